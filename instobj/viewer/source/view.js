// Camera, light, axes and a grid of 10 mm; drawn only when something changes.
import {
  AmbientLight, Color, DirectionalLight, GridHelper, Group, PerspectiveCamera, Quaternion, Scene, Sprite,
  SpriteMaterial, CanvasTexture, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { arrow } from "./arrow.js";

const BACKGROUND = 0xf7f7f4;
const KEY_TURN = 0.12;
const SLOW_MS = 40;
const STILL_MS = 250;
const LEAST_RATIO = 0.4;

export function label(text, size, colour = "#1c1c1c") {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  pen.font = "600 44px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.lineWidth = 8;
  pen.strokeStyle = "rgba(255,255,255,.85)";
  pen.strokeText(text, 32, 34);
  pen.fillStyle = colour;
  pen.fillText(text, 32, 34);
  const material = new SpriteMaterial({ map: new CanvasTexture(canvas), depthTest: false });
  const sprite = new Sprite(material);
  sprite.scale.setScalar(size);
  sprite.renderOrder = 10;
  return sprite;
}

// Whether a face looks at the camera.
export function facing(face, camera) {
  return camera.position.clone().sub(new Vector3(...face.centre_mm)).dot(new Vector3(...face.normal)) > 0;
}

function axes(size, corner) {
  const group = new Group();
  const colours = [0xb3261e, 0x2e7d32, 0x1652b8];
  ["x", "y", "z"].forEach((name, index) => {
    const way = new Vector3().setComponent(index, 1);
    const one = arrow(colours[index], size / 90);
    one.point(corner, way, size / 4);
    group.add(one.object);
    const text = label(name, size / 9, `#${new Color(colours[index]).getHexString()}`);
    text.position.copy(corner).addScaledVector(way, size / 3.4);
    group.add(text);
  });
  return group;
}

// Whether a program draws in place of graphics hardware: there smooth edges cost more than half of a picture.
function drawsInSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return false;
  const named = gl.getExtension("WEBGL_debug_renderer_info");
  const drawnBy = named ? gl.getParameter(named.UNMASKED_RENDERER_WEBGL) : "";
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(drawnBy);
}

// While the camera moves, pictures that come too slowly get fewer pixels; once it rests one is drawn in full.
function makePace(renderer, redraw, slow) {
  let moving = slow ? 0.6 : 1;
  let [before, rest] = [0, 0];
  const full = () => Math.min(devicePixelRatio, 2);
  function still() {
    rest = 0;
    if (renderer.getPixelRatio() !== full()) redraw();
  }
  function moved() {
    if (!rest) before = 0;
    clearTimeout(rest);
    rest = setTimeout(still, STILL_MS);
  }
  // Before a picture at a time; changing the pixels empties the canvas.
  function settle(at) {
    if (rest && before && at - before > SLOW_MS) moving = Math.max(LEAST_RATIO, 0.85 * moving);
    before = at;
    const wanted = full() * (rest ? moving : 1);
    if (renderer.getPixelRatio() !== wanted) renderer.setPixelRatio(wanted);
  }
  return { moved, settle };
}

export function makeView(canvas, sizeMm) {
  const slow = drawsInSoftware();
  const renderer = new WebGLRenderer({ canvas, antialias: !slow });
  renderer.setClearColor(BACKGROUND);
  renderer.localClippingEnabled = true;
  const scene = new Scene();
  const size = 0.58 * Math.hypot(...sizeMm); // 42 mm for a cube of 42 mm
  const camera = new PerspectiveCamera(30, 1, size / 50, size * 30);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  const sun = new DirectionalLight(0xffffff, 2.1);
  sun.position.set(-0.5, 0.65, 0.8);
  camera.add(sun, sun.target);
  sun.target.position.set(0, 0, -1);
  scene.add(camera, new AmbientLight(0xffffff, 1.5));
  const floor = new GridHelper(Math.ceil((3 * size) / 20) * 20, Math.ceil((3 * size) / 20) * 2, 0xb9b9b2, 0xe0e0da);
  floor.rotation.x = Math.PI / 2;
  floor.position.z = -sizeMm[2] / 2 - size * 0.02;
  const ground = new Group();
  ground.add(floor, axes(size, new Vector3(-0.8 * size, -0.8 * size, floor.position.z)));
  scene.add(ground);

  const before = [];
  let asked = false;
  let drawn = 0;
  function draw(at) {
    asked = false;
    pace.settle(at ?? performance.now());
    before.forEach((act) => act(camera));
    renderer.render(scene, camera);
    drawn += 1;
  }
  function redraw() {
    if (!asked) requestAnimationFrame(draw);
    asked = true;
  }
  const pace = makePace(renderer, redraw, slow);
  // From the front corner; or, keeping the direction, from another distance.
  function look(distance = 4.3, lift = 0, keep = false) {
    const way = keep ? camera.position.clone().sub(controls.target) : new Vector3(0.57, -0.68, 0.46);
    const narrow = Math.max(1, 1.25 / camera.aspect);
    controls.target.set(0, 0, lift * size);
    camera.position.copy(controls.target).addScaledVector(way.normalize(), distance * size * narrow);
    controls.update();
    redraw();
  }
  // All of a sphere (mm), from the front corner.
  function frame({ center, radius }) {
    look(1);
    const across = Math.min(1, camera.aspect) * Math.sin((camera.fov * Math.PI) / 360);
    const way = camera.position.clone().sub(controls.target).normalize();
    controls.target.copy(center);
    camera.position.copy(center).addScaledVector(way, radius / across);
    controls.update();
  }
  function resize() {
    const { clientWidth: wide, clientHeight: high } = canvas;
    if (!wide || !high) return;
    renderer.setSize(wide, high, false);
    camera.aspect = wide / high;
    camera.updateProjectionMatrix();
    redraw();
  }
  function moved() {
    pace.moved();
    redraw();
  }
  controls.addEventListener("change", moved);
  new ResizeObserver(resize).observe(canvas);
  canvas.addEventListener("keydown", (event) => turnByKey(event, camera, controls));
  resize();
  look();
  return { renderer, scene, camera, controls, size, draw, redraw, moved, look, frame, before, ground, drawn: () => drawn };
}

function turnByKey(event, camera, controls) {
  const across = new Vector3().crossVectors(camera.position, camera.up).normalize();
  const turns = {
    ArrowLeft: [camera.up, -KEY_TURN], ArrowRight: [camera.up, KEY_TURN],
    ArrowUp: [across, -KEY_TURN], ArrowDown: [across, KEY_TURN],
  };
  const zoom = { "+": 0.9, "=": 0.9, "-": 1 / 0.9 }[event.key];
  const offset = camera.position.clone().sub(controls.target);
  if (turns[event.key]) offset.applyQuaternion(new Quaternion().setFromAxisAngle(...turns[event.key]));
  else if (zoom) offset.multiplyScalar(zoom);
  else return;
  event.preventDefault();
  camera.position.copy(controls.target).add(offset);
  controls.update();
}
