// A solid arrow that can be pointed and lengthened.
import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";

const UP = new Vector3(0, 1, 0);

export function arrow(colour, radius, onTop = false) {
  const material = new MeshBasicMaterial({ color: colour, depthTest: !onTop, transparent: onTop });
  const shaft = new Mesh(new CylinderGeometry(radius, radius, 1, 10), material);
  const head = new Mesh(new ConeGeometry(2.6 * radius, 6 * radius, 14), material);
  const object = new Group();
  object.add(shaft, head);
  if (onTop) shaft.renderOrder = head.renderOrder = 5;
  function point(from, way, length) {
    object.visible = length > 1e-6;
    const body = Math.max(length - 6 * radius, 1e-3);
    object.position.copy(from);
    object.quaternion.setFromUnitVectors(UP, way);
    shaft.scale.y = body;
    shaft.position.y = body / 2;
    head.scale.setScalar(Math.min(1, length / (6 * radius)) || 1);
    head.position.y = Math.max(length, 1e-3) - 3 * radius * head.scale.x;
  }
  return { object, point };
}
