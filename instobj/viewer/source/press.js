// A press: the silicone follows the stored shapes and the tip, magnets move, chips show their change.
import { CylinderGeometry, Group, Mesh, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3 } from "three";
import { arrow } from "./arrow.js";
import { numbers, row } from "./archive.js";
import { circleOf, makeEllipse } from "./ellipse.js";

export function makePress(scene, object, view) {
  const { content, arrays } = scene;
  const { depth_mm: depths, shown_steps: shown } = content.press;
  const [, places, steps] = arrays.force_n.shape;
  const sensors = arrays.sensor_mm.shape[0];
  const geometry = object.silicone.front.geometry;
  const rest = numbers(arrays.silicone_mm);
  const vector = numbers(arrays.link_mm);
  const inward = new Float32Array(arrays.shape.shape[2]);
  const tip = makeTip(content.tip, view.size);
  const arrows = Array.from({ length: sensors }, () => arrow(0xd81b9a, view.size / 130, true));
  const [ring, hovered] = [0xd81b9a, 0x1c1c1c].map((colour) => makeEllipse(scene, object, circle, view, colour));
  const group = new Group();
  const atChips = new Group();
  atChips.add(...arrows.map((one) => one.object));
  group.add(tip, ring.line, hovered.line);
  view.scene.add(group, atChips);
  const sensorAt = Array.from({ length: sensors }, (_, s) => new Vector3(...row(arrays.sensor_mm, s, 3)));
  const chipAxes = Array.from({ length: sensors }, (_, s) => row(arrays.sensor_axes, s, 9));
  const state = { face: 0, place: 0, step: 0 };

  const force = (step) => (step ? arrays.force_n.data[(state.face * places + state.place) * steps + step - 1] : 0);
  const press = () => state.face * places + state.place;

  // Shares of the stored steps' shapes: per newton, linear in depth between two of them.
  function blend(step) {
    const now = force(step);
    if (!step || !now) return [];
    const depth = depths[step - 1];
    const last = shown.length - 1;
    let k = shown.findIndex((s) => depths[s] >= depth);
    k = k < 0 ? last : k;
    const below = Math.max(0, k - 1);
    const part = k === below ? 1 : Math.max(0, (depth - depths[shown[below]]) / (depths[shown[k]] - depths[shown[below]]));
    const weights = k === below ? [[k, 1]] : [[below, 1 - part], [k, part]];
    return weights.filter(([, w]) => w > 0).map(([index, w]) => [index, (w * now) / (force(shown[index] + 1) || now)]);
  }
  function bend(mix) {
    inward.fill(0);
    const { data, shape, step } = arrays.shape;
    const [, kept, vertices] = shape;
    for (const [k, weight] of mix) {
      const scale = weight * step * depths[shown[k]];
      const first = (state.face * kept + k) * vertices;
      for (let v = 0; v < vertices; v++) inward[v] += scale * data[(first + v) * places + state.place];
    }
    const position = geometry.attributes.position;
    position.array.set(rest);
    arrays.link_vertex.data.forEach((vertex, link) => {
      const by = inward[arrays.link_source.data[link]];
      for (let i = 0; i < 3; i++) position.array[3 * vertex + i] += by * vector[3 * link + i];
    });
    if (mix.length) followTip(position.array);
    position.needsUpdate = true;
    geometry.computeVertexNormals();
    geometry.computeBoundingSphere();
  }
  // The silicone does not reach into the tip: where it would, it lies on the tip.
  function followTip(position) {
    const radius = content.tip.radius_mm;
    if (!radius) return;
    const { origin, axes } = placeFrame();
    const centre = origin.clone().addScaledVector(axes[2], radius - depths[state.step - 1]);
    const offset = new Vector3();
    for (let v = 0; v < position.length; v += 3) {
      offset.set(position[v] - centre.x, position[v + 1] - centre.y, position[v + 2] - centre.z);
      if (offset.lengthSq() >= radius * radius) continue;
      const high = offset.dot(axes[2]);
      const down = -Math.sqrt(radius * radius - offset.lengthSq() + high * high) - high;
      position[v] += down * axes[2].x;
      position[v + 1] += down * axes[2].y;
      position[v + 2] += down * axes[2].z;
    }
  }
  function placeFrame() {
    const at = row(arrays.place_axes, press(), 9);
    const axes = [0, 1, 2].map((c) => new Vector3(at[c], at[3 + c], at[6 + c]).normalize());
    return { origin: new Vector3(...row(arrays.place_mm, press(), 3)), axes };
  }
  function moveParts(mix) {
    object.movers.forEach((part, index) => {
      const shift = new Vector3();
      const turn = new Vector3();
      for (const [k, weight] of mix) {
        const at = (press() * shown.length + k) * object.movers.length + index;
        shift.addScaledVector(new Vector3(...row(arrays.motion_mm, at, 3)), weight);
        turn.addScaledVector(new Vector3(...row(arrays.motion_rad, at, 3)), weight);
      }
      const { position, quaternion } = part.userData.rest;
      part.userData.moved = position.clone().add(shift);
      const angle = turn.length();
      const spin = new Quaternion().setFromAxisAngle(angle ? turn.clone().divideScalar(angle) : new Vector3(0, 0, 1), angle);
      part.quaternion.copy(spin.multiply(quaternion));
    });
    object.again();
  }
  function countsOf(sensor) {
    if (!state.step) return [0, 0, 0];
    return row(arrays.counts, (press() * steps + state.step - 1) * sensors + sensor, 3);
  }
  function signals() {
    const noise = content.press.noise_counts;
    const live = arrays.live.data;
    return sensorAt.map((_, s) => ({ sensor: s, face: arrays.sensor_face.data[s], counts: countsOf(s), noise, live: [0, 1, 2].map((a) => live[3 * s + a] > 0) }));
  }
  function point() {
    const most = Math.log1p(32000 / Math.min(...content.press.noise_counts));
    signals().forEach(({ counts, noise, live }, s) => {
      const field = new Vector3();
      let sigmas = 0;
      counts.forEach((count, a) => {
        if (!live[a]) return;
        field.addScaledVector(new Vector3(...chipAxes[s].slice(3 * a, 3 * a + 3)), count);
        sigmas += (count / noise[a]) ** 2;
      });
      const length = field.length() ? (0.75 * view.size * Math.log1p(Math.sqrt(sigmas))) / most : 0;
      arrows[s].point(sensorAt[s], field.normalize(), sigmas > 1 ? length : 0);
    });
  }
  function circle(face, place) {
    return circleOf(...row(arrays.ellipse_mm2, face * places + place, 3));
  }
  function set(face, place, step) {
    Object.assign(state, { face, place, step });
    const mix = blend(step);
    bend(mix);
    moveParts(mix);
    point();
    ring.draw(face, place);
    hovered.hide();
    const { origin, axes } = placeFrame();
    tip.position.copy(origin).addScaledVector(axes[2], -(step ? depths[step - 1] : 0));
    tip.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), axes[2]);
    follow();
  }
  // Tip and ellipse go with the silicone; arrows belong to chips in their places.
  function follow() {
    group.position.copy(object.offset());
    group.visible = object.root.visible;
    atChips.visible = object.root.visible && object.offset().lengthSq() < 1e-6;
    view.redraw();
  }
  // The ellipse at the contact location under the pointer.
  function hover(found) {
    if (found) hovered.draw(found.face, found.place);
    else hovered.hide();
    view.redraw();
  }
  const xy = (place) => Array.from(arrays.place_xy_mm.data.subarray(2 * place, 2 * place + 2));
  return { state, set, hover, xy, ringScale: ring.scale, signals, circle, force: () => force(state.step), depths, group, places, follow };
}

// The tip's lowest point in its origin, its axis along z.
function makeTip({ radius_mm: radius }, size) {
  const material = new MeshLambertMaterial({ color: 0x6d6d75, transparent: true, opacity: 0.55 });
  const tip = new Group();
  const wide = radius ?? size / 20;
  if (radius) {
    const ball = new Mesh(new SphereGeometry(wide, 40, 20), material);
    ball.position.z = wide;
    tip.add(ball);
  }
  const rod = new Mesh(new CylinderGeometry(wide * 0.45, radius ? wide * 0.45 : 0.1, size / 3, 24), material);
  rod.rotation.x = Math.PI / 2;
  rod.position.z = (radius ? wide : 0) + size / 6;
  tip.add(rod);
  tip.traverse((mesh) => (mesh.renderOrder = 3));
  return tip;
}
