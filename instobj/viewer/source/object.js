// The object's parts as meshes: silicone, core, boards, chips, magnets; explosion, clipping, opacity.
import {
  BackSide, Box3, BoxGeometry, BufferAttribute, BufferGeometry, DoubleSide, EdgesGeometry, Group, LineBasicMaterial,
  LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, Plane, Sphere, Vector3,
} from "three";
import { numbers, row } from "./archive.js";
import { label } from "./view.js";

export const COLOURS = {
  silicone: 0xecd6ad, core: 0x8aa5c4, board: 0x1a7338, chip: 0x262626, north: 0xcc2924, south: 0x2952b8,
  cut: 0xc98a5b, mould: 0xa8c49e,
};

export function geometryOf(arrays, name) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(numbers(arrays[`${name}_mm`]), 3));
  geometry.setAttribute("normal", new BufferAttribute(numbers(arrays[`${name}_normals`]), 3));
  geometry.setIndex(new BufferAttribute(arrays[`${name}_triangles`].data, 1));
  return geometry;
}

// A solid whose inside is drawn flat where a clipping plane opens it, as if it were full.
export function solid(geometry, material, planes, cutColour = COLOURS.cut) {
  material.clippingPlanes = planes;
  const inside = new MeshBasicMaterial({ color: cutColour, side: BackSide, clippingPlanes: planes });
  const group = new Group();
  const front = new Mesh(geometry, material);
  const back = new Mesh(geometry, inside);
  group.add(front, back);
  return { group, front, back };
}

export function outline(geometry, planes) {
  const material = new LineBasicMaterial({ color: 0x30373f, clippingPlanes: planes });
  return new LineSegments(new EdgesGeometry(geometry, 35), material);
}

function frame(axes, place) {
  const [a, b, c, d, e, f, g, h, i] = axes;
  return new Matrix4().set(a, b, c, place[0], d, e, f, place[1], g, h, i, place[2], 0, 0, 0, 1);
}

function boxes(arrays, name, colour) {
  const made = [];
  if (!arrays[`${name}_mm`]) return made;
  const material = new MeshLambertMaterial({ color: colour });
  for (let index = 0; index < arrays[`${name}_mm`].shape[0]; index++) {
    const half = row(arrays[`${name}_half_mm`], index, 3);
    const mesh = new Mesh(new BoxGeometry(...half.map((h) => 2 * h)), material);
    place(mesh, frame(row(arrays[`${name}_axes`], index, 9), row(arrays[`${name}_mm`], index, 3)));
    made.push(mesh);
  }
  return made;
}

function place(object, matrix) {
  matrix.decompose(object.position, object.quaternion, object.scale);
  object.userData.rest = { position: object.position.clone(), quaternion: object.quaternion.clone() };
}

function magnets(arrays) {
  const half = geometryOf(arrays, "magnet_half");
  const other = half.clone().rotateX(Math.PI);
  const [north, south] = ["north", "south"].map((pole) => new MeshLambertMaterial({ color: COLOURS[pole] }));
  return Array.from({ length: arrays.magnet_mm.shape[0] }, (_, index) => {
    const group = new Group();
    group.add(new Mesh(half, north), new Mesh(other, south));
    place(group, frame(row(arrays.magnet_axes, index, 9), row(arrays.magnet_mm, index, 3)));
    return group;
  });
}

export function buildObject({ content, arrays }, view) {
  const root = new Group();
  const size = view.size;
  const away = new Vector3(...content.away);
  const height = content.size_mm.reduce((sum, edge, axis) => sum + edge * Math.abs(content.away[axis]), 0);
  const normals = Object.fromEntries(content.faces.map((f) => [f.number, new Vector3(...f.normal)]));
  const plane = new Plane(new Vector3(0, 1, 0), 0);
  const planes = [];

  const skin = new MeshLambertMaterial({ color: COLOURS.silicone, transparent: true });
  const silicone = solid(geometryOf(arrays, "silicone"), skin, planes);
  silicone.front.renderOrder = 2;
  const core = solid(geometryOf(arrays, "core"), new MeshLambertMaterial({ color: COLOURS.core }), planes, 0x5f7ea3);
  core.group.add(outline(core.front.geometry, planes));
  const bars = magnets(arrays);
  const boards = boxes(arrays, "boards", COLOURS.board);
  const chips = boxes(arrays, "chips", COLOURS.chip);
  root.add(silicone.group, core.group, ...bars, ...boards, ...chips);

  const faces = content.faces.map((face) => {
    const sprite = label(String(face.number), size / 8);
    const normal = normals[face.number];
    sprite.position.set(...face.centre_mm).addScaledVector(normal, size * 0.09);
    sprite.userData = { normal, rest: sprite.position.clone() };
    root.add(sprite);
    return sprite;
  });
  view.before.push((camera) => {
    for (const sprite of faces) {
      const seen = camera.position.clone().sub(sprite.position);
      sprite.visible = root.visible && seen.dot(sprite.userData.normal) > 0;
    }
  });

  const boardFaces = Array.from(arrays.sensor_face.data);
  const magnetFaces = Array.from(arrays.magnet_face.data);
  const inShell = content.magnets_in_shell ? bars : boards;
  const inCore = content.magnets_in_shell ? [...boards, ...chips] : bars;
  const faceOf = (part) => {
    const found = bars.includes(part) ? magnetFaces[bars.indexOf(part)]
      : boardFaces[(boards.includes(part) ? boards : chips).indexOf(part)];
    return normals[found];
  };
  let exploded = 0;
  function explode(share) {
    exploded = share;
    const lift = away.clone().multiplyScalar(0.95 * height * share);
    silicone.group.position.copy(lift);
    faces.forEach((s) => s.position.copy(s.userData.rest).add(lift).addScaledVector(s.userData.normal, 0.2 * size * share));
    for (const part of inShell) part.position.copy(restOf(part)).add(lift).addScaledVector(faceOf(part), 0.2 * size * share);
    for (const part of inCore) part.position.copy(restOf(part)).addScaledVector(faceOf(part), 0.16 * size * share);
    view.redraw();
  }
  const restOf = (part) => part.userData.moved ?? part.userData.rest.position;

  function clip(axis, share) {
    planes.length = 0;
    if (axis) {
      plane.normal.set(0, 0, 0).setComponent("xyz".indexOf(axis), axis === "y" ? 1 : -1);
      plane.constant = (share * content.size_mm["xyz".indexOf(axis)]) / 2;
      planes.push(plane);
    }
    [silicone, core].forEach((one) => (one.back.visible = planes.length > 0));
    [silicone, core].forEach((one) => one.group.traverse((m) => m.material && (m.material.needsUpdate = true)));
    view.redraw();
  }
  function fade(opacity) {
    skin.opacity = opacity;
    skin.depthWrite = opacity > 0.95;
    view.redraw();
  }
  clip("", 0);
  return {
    root, silicone, core, faces, movers: inShell, explode, clip, fade,
    offset: () => silicone.group.position, again: () => explode(exploded),
  };
}

export function buildMould({ content, arrays }, view) {
  const root = new Group();
  const tints = [0xa8c49e, 0x94b38a, 0xc2b3d6, 0xd9c9a0];
  const pieces = content.mould.map((piece, index) => {
    const shell = piece.name === "cast shell";
    const material = new MeshLambertMaterial({
      color: shell ? COLOURS.silicone : piece.name.startsWith("core") ? COLOURS.core : tints[index % tints.length],
      side: DoubleSide, transparent: !shell, opacity: shell ? 1 : 0.9,
    });
    const mesh = new Mesh(geometryOf(arrays, `mould_${index}`), material);
    mesh.add(outline(mesh.geometry, []));
    root.add(mesh);
    return { ...piece, mesh, pull: new Vector3(...piece.pull_mm) };
  });
  function open(share) {
    for (const { mesh, pull, begins, ends } of pieces) {
      const done = Math.min(1, Math.max(0, (share - begins) / (ends - begins)));
      mesh.position.copy(pull).multiplyScalar(done);
    }
    view.redraw();
  }
  // What the pieces take up, closed and opened.
  function bounds() {
    const box = new Box3();
    for (const { mesh, pull } of pieces) {
      mesh.geometry.computeBoundingBox();
      box.union(mesh.geometry.boundingBox).union(mesh.geometry.boundingBox.clone().translate(pull));
    }
    return box.getBoundingSphere(new Sphere());
  }
  open(0);
  root.visible = false;
  return { root, open, pieces, bounds };
}
