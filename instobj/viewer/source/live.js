// The live page: frames from the server's WebSocket onto the body, into strips and tables.
import { readArchive } from "./archive.js";
import { makeContacts } from "./contacts.js";
import { readMessage } from "./messages.js";
import { buildObject } from "./object.js";
import { makeStrips } from "./strips.js";
import { makeView } from "./view.js";

const STATES = ["good", "absent", "silent", "saturated", "dead", "noisy", "drifting"];
const AGAIN_MS = 1000;
const KEPT_FIGURES = 8192;
const SLOW_MS = 40;
const PATIENCE = 15;
const LEAST_RATIO = 0.4;

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
  const view = makeView(find("canvas"), content.size_mm, !drawsInSoftware());
  const object = buildObject(scene, view);
  view.scene.add(object.root);
  const contacts = makeContacts(view, find("canvas").parentElement);
  const faces = content.faces.map((face) => face.number);
  const strips = makeStrips(find, channels, faces);
  const keepPace = makePace(view);
  const health = makeHealth(find("health"), channels);
  object.fade(Number(find("opacity").value) / 100);
  find("opacity").addEventListener("input", () => object.fade(Number(find("opacity").value) / 100));

  const figures = { shown: 0, messages: 0, rows: 0, dropped: 0, latency: [], age: [], work: [], drawn: [] };
  let socket, waiting, state = {};
  const note = (list, value) => { list.push(value); if (list.length > KEPT_FIGURES) list.shift(); };

  // Everything that came since the last picture is drawn once; the picture is on the screen one later.
  function draw(at) {
    requestAnimationFrame(draw);
    if (drawn) {
      const now = performance.timeOrigin + performance.now();
      note(figures.latency, now - 1000 * (drawn.readS || drawn.arrivedS));
      note(figures.age, now - 1000 * drawn.arrivedS);
      drawn = null;
    }
    if (!waiting) return;
    const from = performance.now();
    keepPace(at);
    contacts.show(waiting.contacts, waiting.labels);
    listContacts(find("contacts"), waiting.contacts);
    view.draw();
    strips.draw(at);
    if (socket.readyState === WebSocket.OPEN) socket.send(Uint32Array.of(waiting.number));
    [drawn, waiting] = [waiting, null];
    figures.shown += 1;
    note(figures.drawn, at);
    note(figures.work, performance.now() - from);
  }
  let drawn = null;

  function receive({ data }) {
    const message = readMessage(data, channels.length);
    if (message.state) return tell((state = message.state));
    figures.messages += 1;
    figures.rows += message.rows;
    figures.dropped = message.dropped;
    strips.take(message);
    waiting = message;
  }
  function tell(now) {
    health.show(now.health ?? []);
    const { recording } = now;
    find("record").setAttribute("aria-pressed", String(Boolean(recording?.on)));
    find("record").textContent = recording?.on ? "recording" : "record";
    find("record").title = recording?.file ? `into ${recording.file}` : "";
    find("zero").textContent = now.zeroed ? "zero" : "zeroing …";
    find("trouble").textContent = [now.told, now.trouble, now.explained === false ? "no contact that the model knows explains these readings" : ""].filter(Boolean).join("; ");
    find("told").textContent = summary(now, figures);
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
  window.instobjLive = { figures: () => summarised(figures), state: () => state, contacts: contacts.shown, pictureMs: () => pictureMs(view) };
  document.getElementById("instobj-live").dataset.ready = "yes";
}

// Whether a program draws in place of graphics hardware: smooth edges would cost it most of its time.
function drawsInSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const named = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = named ? gl.getParameter(named.UNMASKED_RENDERER_WEBGL) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

// Pictures that come too slowly, on machines that draw without graphics hardware, get fewer pixels.
function makePace(view) {
  let [before, late] = [0, 0];
  return (at) => {
    late = at - before > SLOW_MS ? late + 1 : 0;
    before = at;
    const ratio = view.renderer.getPixelRatio();
    if (late < PATIENCE || ratio <= LEAST_RATIO) return;
    view.renderer.setPixelRatio(Math.max(LEAST_RATIO, 0.7 * ratio));
    late = 0;
  };
}

// Until the graphics have really drawn: for measurements, as it waits.
function pictureMs(view) {
  const gl = view.renderer.getContext();
  const from = performance.now();
  view.draw();
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return performance.now() - from;
}

function summary(now, figures) {
  const shown = summarised(figures);
  const { recording, counted } = now;
  const parts = [now.source, `${fixed(now.rate_hz, 0)} frames/s`];
  if (counted) parts.push(`${counted.lost} lost, ${counted.damaged} damaged lines, ${counted.restarts} restarts`);
  if (recording) parts.push(recording.on || recording.rows ? `${recording.rows} rows in ${recording.file}${recording.unlabelled ? `, ${recording.unlabelled} frames without a force not written` : ""}` : "not recording");
  parts.push(`${fixed(shown.perSecond, 0)} pictures/s, ${fixed(shown.latencyMs.p50, 0)} ms old (99 %: ${fixed(shown.latencyMs.p99, 0)})`);
  if (figures.dropped || now.unsent) parts.push(`${figures.dropped + (now.unsent ?? 0)} frames not shown here`);
  return parts.filter(Boolean).join(" · ");
}

const fixed = (value, digits) => (Number.isFinite(value) ? value.toFixed(digits) : "–");

// What the page measures of itself, times in ms.
function summarised({ latency, age, work, drawn, ...counts }) {
  const recent = drawn.filter((at) => at > performance.now() - 3000);
  const perSecond = recent.length > 1 ? (1000 * (recent.length - 1)) / (recent.at(-1) - recent[0]) : 0;
  return { ...counts, perSecond, latencyMs: shares(latency), ageMs: shares(age), workMs: shares(work) };
}

function shares(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  return { count: sorted.length, p50: at(0.5), p90: at(0.9), p99: at(0.99), most: sorted.at(-1) };
}

function listContacts(body, contacts) {
  body.replaceChildren(...contacts.map((one) => {
    const line = document.createElement("tr");
    const cells = [one.face, fixed(one.x, 1), fixed(one.y, 1), fixed(one.radius, 1), `${fixed(one.force, 2)} ± ${fixed(one.halfwidth, 2)}`];
    cells.forEach((cell) => line.insertCell().append(String(cell).replace("-", "−")));
    return line;
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
