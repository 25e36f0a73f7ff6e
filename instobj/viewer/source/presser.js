// Presses on the explorer's page: balls where they are, the bent skin, moved magnets, ellipses of what is
// told, and each chip's counts.
import { Mesh, MeshLambertMaterial, SphereGeometry, Vector3 } from "three";
import { numbers, row } from "./archive.js";
import { circleOf, makeEllipse } from "./ellipse.js";
import { shownNumber } from "./maps.js";
import { facing } from "./view.js";

const [PRESSED, WORST] = [0xd81b9a, 0xffffff];

export function makePresser({ scene, body, parts, maps, view, find }) {
  const { content, arrays } = scene;
  const places = arrays.place_xy_mm.shape[0];
  const normals = numbers(arrays.silicone_normals);
  const rest = numbers(arrays.silicone_mm);
  let shown = [];
  const circle = (face, place) => shown.find((one) => one.face === face && one.place === place)?.circle ?? circleOf(null);
  const rings = [0, 1].map(() => makeEllipse(scene, body, circle, view, PRESSED));
  const [worst, ...balls] = [WORST, PRESSED, PRESSED].map((color) => {
    const mesh = new Mesh(new SphereGeometry(view.size / (color === WORST ? 45 : 60), 24, 16), new MeshLambertMaterial({ color, depthTest: false, transparent: true, opacity: 0.9 }));
    mesh.renderOrder = 7;
    mesh.visible = false;
    return mesh;
  });
  view.scene.add(...rings.map((ring) => ring.line), worst, ...balls);
  const put = (mesh, face, place) => {
    mesh.position.fromArray(arrays.place_mm.data, 3 * (face * places + place));
    mesh.userData.face = content.faces[face];
  };
  view.before.push((camera) => [worst, ...balls].forEach((mesh) => (mesh.visible = Boolean(mesh.userData.face) && facing(mesh.userData.face, camera))));

  // The skin's own normal at a place: a curved face has another one at each.
  function dentAt({ face, place }, profile) {
    const origin = new Vector3(...row(arrays.place_mm, face * places + place, 3));
    let [near, nearest] = [Infinity, -1];
    maps.owner.forEach((index, v) => {
      if (index !== face) return;
      const far = Math.hypot(rest[3 * v] - origin.x, rest[3 * v + 1] - origin.y, rest[3 * v + 2] - origin.z);
      if (far < near) [near, nearest] = [far, v];
    });
    const normal = nearest < 0 ? content.faces[face].normal : normals.subarray(3 * nearest, 3 * nearest + 3);
    return { origin, normal: new Vector3(...normal), profile };
  }
  function show(presses, { counts, noise_counts: noise, position_mm2: ellipses, motions, skin_mm: profile }, xys, force) {
    shown = presses.map((press, k) => ({ ...press, circle: circleOf(ellipses[k][0], ellipses[k][1], ellipses[k][3]) }));
    body.bend(shown.map((press) => dentAt(press, profile)));
    parts.move({ face: presses[0].face, motions });
    rings.forEach((ring, k) => {
      ring.hide();
      ring.draw(0, NaN);
      if (shown[k]) ring.draw(shown[k].face, shown[k].place);
    });
    balls.forEach((ball, k) => (shown[k] ? put(ball, shown[k].face, shown[k].place) : (ball.userData.face = null)));
    tell(xys, counts, noise, force);
    view.redraw();
  }
  function tell(xys, counts, noise, force) {
    const each = shown.map(({ circle: { most, least } }, k) => `(${xys[k].map((value) => value.toFixed(1)).join(", ")}) mm to ${shownNumber(most)} × ${shownNumber(least)} mm`);
    const both = shown.length > 1 ? "Both presses are read from the same chips at once. " : "";
    find("pressed").textContent = `${force} N on face ${content.faces[shown[0].face].number}: the place is told at ${each.join(" and at ")} (one standard deviation); a ring holds 95 of 100 readings. ${both}The skin is drawn as that of a flat layer. Change of this face's chips in counts, with one standard deviation of noise; bold stands out of it:`;
    find("press-head").hidden = false;
    find("counts").replaceChildren(...Array.from({ length: counts.length / 3 }, (_, chip) => {
      const line = document.createElement("tr");
      line.append(Object.assign(document.createElement("th"), { textContent: `${chip + 1}` }));
      counts.slice(3 * chip, 3 * chip + 3).forEach((count, axis) => {
        const cell = line.insertCell();
        cell.textContent = count === null ? "–" : `${count.toFixed(0).replace("-", "−")} ± ${noise[axis].toFixed(0)}`;
        cell.style.fontWeight = Math.abs(count) > 3 * noise[axis] ? "700" : "";
      });
      return line;
    }));
  }
  function release() {
    shown = [];
    body.bend([]);
    parts.move(null);
    rings.forEach((ring) => ring.hide());
    balls.forEach((ball) => (ball.userData.face = null));
    find("pressed").textContent = "No press.";
    find("press-head").hidden = true;
    find("counts").replaceChildren();
    view.redraw();
  }
  return { show, release, markWorst: (face, place) => put(worst, face, place) };
}
