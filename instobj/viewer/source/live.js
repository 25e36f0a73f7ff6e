// The live page: frames from the server's WebSocket onto the body, into strips and tables.
import { readArchive } from "./archive.js";
import { makeContacts } from "./contacts.js";
import { makeFigures } from "./figures.js";
import { readMessage } from "./messages.js";
import { buildObject } from "./object.js";
import { makeStrips } from "./strips.js";
import { makeView } from "./view.js";

const STATES = ["good", "absent", "silent", "saturated", "dead", "noisy", "drifting"];
const AGAIN_MS = 1000;
const TABLE_MS = 100;

async function startLive() {
  const find = (name) => document.querySelector(`[data-name="${name}"]`);
  const answer = await fetch(`/scene${location.search}`);
  if (!answer.ok) throw new Error(`the server refused the scene (${answer.status})`);
  const scene = await readArchive(new Uint8Array(await answer.arrayBuffer()));
  const { content } = scene;
  const { channels } = content.live;
  find("name").textContent = `${content.name}, live`;
  document.title = `${content.name}, live`;
  find("key").textContent = content.live.key;
  const view = makeView(find("canvas"), content.size_mm);
  const object = buildObject(scene, view);
  view.scene.add(object.root);
  const contacts = makeContacts(view, find("overlay"), object.silicone.front.geometry);
  const faces = content.faces.map((face) => face.number);
  const strips = makeStrips(find, channels, faces);
  const health = makeHealth(find("health"), channels);
  object.fade(Number(find("opacity").value) / 100);
  find("opacity").addEventListener("input", () => object.fade(Number(find("opacity").value) / 100));

  const figures = makeFigures();
  let socket, waiting, drawn, state = {};
  let listedAt = 0;

  // Everything that came since the last picture is drawn once; the picture is on the screen one later.
  function draw(at) {
    requestAnimationFrame(draw);
    if (drawn) figures.seen(drawn);
    drawn = null;
    if (!waiting) return;
    const from = performance.now();
    contacts.show(waiting.contacts, waiting.labels);
    if (at - listedAt >= TABLE_MS) {
      listContacts(find("contacts"), waiting.contacts);
      listedAt = at;
    }
    strips.draw(at);
    if (socket.readyState === WebSocket.OPEN) socket.send(Uint32Array.of(waiting.number));
    [drawn, waiting] = [waiting, null];
    figures.drawn(performance.now() - from);
  }

  function receive({ data }) {
    const message = readMessage(data, channels.length);
    if (message.state) return tell((state = message.state));
    figures.came(message);
    strips.take(message);
    waiting = message;
  }
  function tell(now) {
    health.show(now.health ?? []);
    listGrasps(find("grasps"), now.grasps ?? []);
    const { recording } = now;
    find("record").setAttribute("aria-pressed", String(Boolean(recording?.on)));
    find("record").textContent = recording?.on ? "recording" : "record";
    find("record").title = recording?.file ? `into ${recording.file}` : "";
    find("zero").textContent = now.zeroed ? "zero" : "zeroing …";
    const trouble = [now.told, now.trouble, now.explained === false ? "no contact that the model knows explains these readings" : ""].filter(Boolean).join("; ");
    if (find("trouble").textContent !== trouble) find("trouble").textContent = trouble; // an alert: read out when it changes
    find("told").textContent = summary(now, figures.told());
  }
  function connect() {
    socket = new WebSocket(`ws://${location.host}/stream${location.search}`);
    socket.binaryType = "arraybuffer";
    socket.onmessage = receive;
    socket.onclose = () => {
      find("told").textContent = "the server does not answer; what was recorded is kept";
      setTimeout(connect, AGAIN_MS);
    };
  }
  find("zero").addEventListener("click", () => socket.send("zero"));
  find("record").addEventListener("click", () => socket.send(state.recording?.on ? "record off" : "record on"));
  requestAnimationFrame(draw);
  connect();
  window.instobjLive = {
    figures: () => ({ ...figures.told(), objectDrawn: view.drawn() }), forget: figures.forget, state: () => state,
    contacts: contacts.shown, labels: contacts.told, hidden: contacts.hidden, pictureMs: () => pictureMs(view),
  };
  document.getElementById("instobj-live").dataset.ready = "yes";
}

// Until the graphics have really drawn: for measurements, as it waits.
function pictureMs(view) {
  const gl = view.renderer.getContext();
  const from = performance.now();
  view.draw();
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return performance.now() - from;
}

function summary(now, shown) {
  const { recording, counted } = now;
  const parts = [now.source, `${fixed(now.rate_hz, 0)} frames/s`];
  if (counted) parts.push(`${counted.lost} lost, ${counted.damaged} damaged lines, ${counted.restarts} restarts`);
  if (recording) parts.push(recording.on || recording.rows ? `${recording.rows} rows in ${recording.file}${recording.unlabelled ? `, ${recording.unlabelled} frames without a force not written` : ""}` : "not recording");
  parts.push(`${fixed(shown.perSecond, 0)} pictures/s, ${fixed(shown.latencyMs.p50, 0)} ms old (99 %: ${fixed(shown.latencyMs.p99, 0)})`);
  if (shown.dropped) parts.push(`${shown.dropped} frames not shown here`);
  return parts.filter(Boolean).join(" · ");
}

const fixed = (value, digits) => (Number.isFinite(value) ? value.toFixed(digits) : "–");

function listContacts(body, contacts) {
  body.replaceChildren(...contacts.map((one) => {
    const line = document.createElement("tr");
    const cells = [one.face, fixed(one.x, 1), fixed(one.y, 1), fixed(one.radius, 1), `${fixed(one.force, 2)} ± ${fixed(one.halfwidth, 2)}`];
    cells.forEach((cell) => line.insertCell().append(String(cell).replace("-", "−")));
    return line;
  }));
}

// The newest first; a grasp that is listed never changes.
function listGrasps(body, grasps) {
  const newest = grasps.at(-1)?.grasp ?? 0;
  if (body.dataset.newest === String(newest)) return;
  body.dataset.newest = newest;
  body.replaceChildren(...grasps.toReversed().flatMap((grasp) => {
    const [line, answer] = ["tr", "tr"].map((kind) => document.createElement(kind));
    const cells = [grasp.peak_n, grasp.grasp_n, grasp.slip_mm].map((figure) => figure ?? "–");
    [grasp.grasp, ...cells].forEach((cell) => line.insertCell().append(String(cell)));
    const text = answer.insertCell();
    text.colSpan = 4;
    text.append(grasp.text.replace(/^[^:]*: /, ""));
    return [line, answer];
  }));
}

function makeHealth(body, channels) {
  const cells = [];
  for (let first = 0; first < channels.length; first += 3) {
    const [, face, chip] = channels[first].match(/^F(\d)-X(\d+)$/);
    const line = body.insertRow();
    line.insertCell().append(face);
    line.insertCell().append(chip);
    for (let axis = 0; axis < 3; axis++) cells.push(line.insertCell());
  }
  function show(health) {
    health.forEach((number, index) => {
      if (cells[index].className === STATES[number]) return;
      cells[index].className = STATES[number];
      cells[index].textContent = STATES[number];
    });
  }
  return { show };
}

if (document.getElementById("instobj-live")) {
  startLive().catch((error) => {
    document.querySelector('[data-name="trouble"]').textContent = `No live view: ${error.message}.`;
    console.warn(error);
  });
}
