// Contacts on the body: a disc of the 90 % radius, an arrow of the force, its number; crosses where labels are.
import {
  BufferGeometry, CircleGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineLoop, LineSegments, Mesh,
  MeshBasicMaterial, Quaternion, Vector3,
} from "three";
import { arrow } from "./arrow.js";

const COLOUR = 0xd81b9a;
const TOLD = 0x0b5c3b;
const MM_PER_N = 1.6;
const UP = new Vector3(0, 0, 1);

function ringPoints(corners) {
  const points = [];
  for (let k = 0; k < corners; k++) points.push(Math.cos((2 * Math.PI * k) / corners), Math.sin((2 * Math.PI * k) / corners), 0);
  return new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
}

function makeOne(view, stage) {
  const flat = new Group();
  const disc = new Mesh(new CircleGeometry(1, 40), new MeshBasicMaterial({ color: COLOUR, transparent: true, opacity: 0.3, depthWrite: false, side: 2 }));
  const ring = new LineLoop(ringPoints(48), new LineBasicMaterial({ color: COLOUR }));
  disc.renderOrder = ring.renderOrder = 6;
  flat.add(disc, ring);
  const force = arrow(COLOUR, view.size / 110);
  force.object.renderOrder = 7;
  const tag = document.createElement("span");
  tag.className = "tag";
  stage.append(tag);
  view.scene.add(flat, force.object);
  return { flat, force, tag, at: new Vector3(), way: new Vector3() };
}

function makeCross(view) {
  const points = [-1, 0, 0, 1, 0, 0, 0, -1, 0, 0, 1, 0];
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  const cross = new LineSegments(geometry, new LineBasicMaterial({ color: TOLD }));
  cross.scale.setScalar(view.size / 18);
  cross.renderOrder = 8;
  view.scene.add(cross);
  return cross;
}

export function makeContacts(view, stage) {
  const pool = [];
  const crosses = [];
  let now = [];

  function showOne(one, contact) {
    const normal = new Vector3(...contact.normal);
    one.flat.position.set(...contact.point).addScaledVector(normal, 0.15);
    one.flat.quaternion.copy(new Quaternion().setFromUnitVectors(UP, normal));
    one.flat.scale.setScalar(Number.isFinite(contact.radius) ? Math.max(contact.radius, 0.05) : 0.05);
    one.way.set(...contact.pull);
    const length = one.way.length() * MM_PER_N;
    one.way.normalize();
    one.at.set(...contact.point).addScaledVector(one.way, -length);
    one.force.point(one.at, one.way, length);
    one.tag.textContent = `${contact.force.toFixed(1)} N`;
  }
  // Numbers stand at the arrows' ends, on the picture.
  function placeTags(camera) {
    const { clientWidth: wide, clientHeight: high } = stage;
    pool.forEach((one, k) => {
      one.tag.hidden = k >= now.length;
      if (one.tag.hidden) return;
      const { x, y } = one.at.clone().project(camera);
      one.tag.style.transform = `translate(${((x + 1) / 2) * wide + 6}px, ${((1 - y) / 2) * high - 22}px)`;
    });
  }
  view.before.push(placeTags);

  function show(contacts, labels) {
    now = contacts;
    while (pool.length < contacts.length) pool.push(makeOne(view, stage));
    pool.forEach((one, k) => {
      one.flat.visible = one.force.object.visible = k < contacts.length;
      if (k < contacts.length) showOne(one, contacts[k]);
    });
    while (crosses.length < labels.length) crosses.push(makeCross(view));
    crosses.forEach((cross, k) => {
      cross.visible = k < labels.length;
      if (!cross.visible) return;
      const normal = new Vector3(...labels[k].normal);
      cross.position.set(...labels[k].point).addScaledVector(normal, 0.25);
      cross.quaternion.setFromUnitVectors(UP, normal);
    });
  }
  return { show, shown: () => now };
}
