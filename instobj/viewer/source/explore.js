// The page of `instobj explore`: parts are dragged by hand, and the map of what is told follows. The page
// holds the design; its server judges it, or the page's own answers where it was exported.
import {
  BoxGeometry, Color, CylinderGeometry, InstancedMesh, Mesh, MeshLambertMaterial, Plane, Quaternion, Raycaster, Vector2, Vector3,
} from "three";
import { bytesOf, numbers, readArchive } from "./archive.js";
import { addNumber, boxOf, makeMagnet, makePool, quaternionOf } from "./layouts.js";
import { drawLegend, makeMaps, placeOn, shownNumber } from "./maps.js";
import { COLOURS, geometryOf, outline, solid } from "./object.js";
import { makePresser } from "./presser.js";
import { facing, label, makeView } from "./view.js";
import { makeWork } from "./work.js";

const TITLES = {
  position: ["Error of the place, one standard deviation", "mm"],
  force: ["Error of the force, one standard deviation", "N"],
  least: ["Least force that is felt", "N"],
};
const [STILL, MOVED] = ["bench", "grasp"]; // uses without and with what changes since the zero
const STEP_MM = 0.1;
const RED = 0xe01b24;
const WORSE = [0.5, 2];
const SIZES = ["size-x", "size-y", "size-z"];
const MOVED_PX = 4;
const CHECK_EVERY_MS = 300;
const [GRASPED, MOST_PARTS] = [1, 1024]; // layer of the parts that rays meet; copies of them are drawn
const ENDLESS = 1e9; // of what no force is enough for: darker than all

const copy = (value) => JSON.parse(JSON.stringify(value));
const made = (tag, properties) => Object.assign(document.createElement(tag), properties);
// What stays as it is costs no layout.
const write = (element, text) => element.textContent !== text && (element.textContent = text);
// Of a face, along x and y: a part just as far out as a search goes breaks the limit, so hands stop a step before.
const roomsOf = (content, kind) => content.room_mm[kind].map((room) => room.map((half) => Math.max(half - STEP_MM, 0)));
const rounded = (value) => Math.round(value / STEP_MM) / (1 / STEP_MM);

async function post(question, body) {
  const sent = { method: "POST", body: JSON.stringify(body), headers: { "Content-Type": "application/json" } };
  const answer = await fetch(`/${question}`, sent).catch(() => { throw new Error("The server does not answer. Start instobj explore again on the same port: this page keeps the design."); });
  const found = await answer.json();
  if (!answer.ok) throw new Error(found.error ?? answer.statusText);
  return found;
}

// Answers that were written into the page.
function heldAnswers(element) {
  const held = JSON.parse(element.textContent);
  return async (question, { figure, force_n: force, face, places }) => {
    if (question === "limits" || question === "range") return held[question];
    if (question === "judge") return held[`judge ${figure} ${force}`];
    return held[`press ${face} ${force}`][places[0]];
  };
}

// Body, places and accuracy of a design's shell; of the server's own where there is no design yet.
async function fetchScene(design) {
  const answer = await fetch("/scene", design && { method: "POST", body: JSON.stringify({ design }), headers: { "Content-Type": "application/json" } });
  return readArchive(new Uint8Array(await answer.arrayBuffer()));
}

// From a notebook's widget: map and design are traits of its model, other answers are messages.
function modelAnswers(model) {
  const waiting = new Map();
  let asked = 0;
  const settle = (number, answer) => {
    const [done, fail] = waiting.get(number) ?? [];
    waiting.delete(number);
    if (done) answer.error ? fail(new Error(answer.error)) : done(answer);
  };
  const answered = (send) => new Promise((done, fail) => { waiting.set(++asked, [done, fail]); send(asked); });
  model.on("change:map", () => settle(model.get("map").request, model.get("map")));
  model.on("msg:custom", ({ number, answer }, buffers) => settle(number, answer ?? buffers[0]));
  const ask = (question, query) => answered((number) => {
    if (question !== "judge") return model.send({ number, question, query });
    for (const [name, value] of Object.entries({ ...copy(query), request: number })) model.set(name, value);
    model.save_changes();
  });
  const openScene = async (design) => readArchive(design ? await ask("scene", { design }) : model.get("scene"));
  return { ask, openScene };
}

const ofPage = () => {
  const [answers, scene] = ["answers", "scene"].map((name) => document.getElementById(name));
  if (!answers) return { ask: post, openScene: fetchScene };
  return { ask: heldAnswers(answers), openScene: () => readArchive(bytesOf(scene.textContent)), held: true };
};

// `model`: of a notebook's widget, whose element is the `root`.
export async function startExplore(root, model) {
  const { ask, openScene, held } = model ? modelAnswers(model) : ofPage();
  const find = (name) => root.querySelector(`[data-name="${name}"]`);
  let scene = await openScene();
  let { content, arrays } = scene;
  root.classList.toggle("frozen", Boolean(held));
  find("name").textContent = held ? `${content.name}, to look at and press` : `${content.name}, explored`;
  if (held) find("hint").textContent = "drag: turn · shift and click: press";
  content.forces_n.forEach((force) => find("force").append(new Option(`${force} N`, force)));
  Object.keys(content.chips).forEach((name) => find("chip-part").append(new Option(name)));
  const first = copy(content.design);
  const asWritten = new Option(`as written (${content.as_written})`, "");
  asWritten.disabled = typeof first.magnets.grade === "string"; // its name stands there
  find("grade").append(asWritten, ...content.grades.map((name) => new Option(name)));
  find("disturbed").disabled = Boolean(held);
  content.silicones.forEach((name) => find("silicone").append(new Option(name)));
  find("of-size").hidden = !content.sizable;
  find("force").value = String(content.first_force_n);

  const view = makeView(find("canvas"), content.size_mm);
  const alwaysThere = new Set(view.scene.children);
  const state = { design: copy(content.design), answer: null, broken: [], used: null, pinned: null, chosen: null, presses: [] };
  const history = { past: [], future: [] };
  const latencies = [];
  let body, places, maps, parts, presser;

  // The object of a shell, in place of the one before.
  function build(made) {
    scene = made;
    ({ content, arrays } = made);
    view.before.length = 0;
    view.scene.children.filter((one) => !alwaysThere.has(one)).forEach((one) => {
      view.scene.remove(one);
      one.traverse((part) => part.geometry?.dispose());
    });
    places = arrays.place_xy_mm.shape[0];
    arrays.map_live = { data: new Float32Array(content.faces.length * places).fill(NaN) };
    content.maps = [{ stem: "live", weak: "high", log: true }];
    body = makeBody(scene, view);
    maps = makeMaps(scene, body, view);
    parts = makeParts(view, content);
    presser = makePresser({ scene, body, parts, maps, view, find });
    state.presses = [];
    find("accuracy").textContent = content.accuracy;
    find("level").textContent = content.level;
    body.fade(Number(find("opacity").value) / 100);
  }
  build(scene);

  // One question at a time; what changes meanwhile is asked next, with the newest design only.
  let [busy, again, asked] = [false, false, 0];
  let [checking, checkAgain, adding] = [false, false, false];
  const question = (design) => ({ design, figure: find("figure").value, force_n: Number(find("force").value) });
  async function update(handAt) {
    if (handAt) asked = asked || handAt;
    if (busy) return void (again = true);
    busy = true;
    const from = asked;
    asked = 0;
    try {
      state.answer = await judged(state.design);
      find("trouble").textContent = "";
      show();
      if (from) requestAnimationFrame(() => requestAnimationFrame(() => latencies.push(performance.now() - from)));
      if (state.presses.length) await press(state.presses);
      checkLimits();
      if (!content.scene.endsWith("full")) work.watch();
    } catch (error) {
      find("trouble").textContent = error.message;
    }
    busy = false;
    if (again) { again = false; return void update(); }
    await ask("range", { design: state.design }).then((found) => (state.used = found.range_used), () => (state.used = null));
    fillNumbers();
  }
  // Another shell has other places, and so has a shell whose own mechanics came.
  async function judged(design) {
    let answer = await ask("judge", question(design));
    while (answer.scene !== content.scene) {
      build(await openScene(design));
      answer = await ask("judge", question(design));
    }
    return answer;
  }
  const limitsOf = (design) => ask("limits", { design }).catch(({ message }) => ({ broken: [{ text: message, magnets: [], sensors: [], faces: [] }] }));
  // Beside the map, as it takes longer; the newest design is checked at the end.
  async function checkLimits() {
    if (checking) return void (checkAgain = true);
    checking = true;
    do {
      checkAgain = false;
      const rest = new Promise((done) => setTimeout(done, CHECK_EVERY_MS)); // of the processor, for the hand
      showLimits(await limitsOf(state.design));
      await rest;
    } while (checkAgain);
    checking = false;
  }

  function show() {
    const { answer, pinned } = state;
    const difference = find("difference").checked && pinned?.answer.scene === answer.scene;
    const [[title, unit], force_n] = [TITLES[find("figure").value], find("force").value];
    answer.values.forEach((value, k) => {
      arrays.map_live.data[k] = value === null ? (arrays.there.data[k] ? ENDLESS : NaN) : difference ? value / pinned.answer.values[k] : value;
    });
    Object.assign(content.maps[0], difference ? { title: "Now over pinned; above 1 is worse", unit: "times" } : { title, unit }, { force_n });
    maps.fix("live", difference ? WORSE : (state.ends ??= endsOf(answer.values.filter((value) => value > 0))));
    drawLegend(find("legend"), maps.show("live"));
    parts.place(answer.parts);
    view.moved();
    paintBroken();
    fillNumbers();
    showPart();
  }
  function fillNumbers() {
    const { answer, pinned, used } = state;
    const figure = find("figure").value;
    const [now, then] = [answer.summary[figure], pinned?.answer.summary[figure]];
    const unit = TITLES[figure][1];
    const limit = content.limits[figure]; // of a go; the force has none
    const rows = [
      [`half of the places are below, ${unit}`, now.median, then?.median],
      [`95 of 100 places are below, ${unit}`, now.percentile_95, then?.percentile_95],
      [`worst place${limit ? ` (for a go ${limit} or less)` : ""}, ${unit}`, now.worst, then?.worst],
      ["chips' range in use, %", used ? 100 * used : "…", pinned?.used ? 100 * pinned.used : ""],
      ["magnets; chips", `${answer.magnets}; ${answer.sensors}`, pinned ? `${pinned.answer.magnets}; ${pinned.answer.sensors}` : ""],
      ["price of both, €; work by hand, min", answer.price_and_minutes.map(Math.round).join("; "), pinned?.answer.price_and_minutes.map(Math.round).join("; ")],
    ];
    if (!find("numbers").rows.length) find("numbers").replaceChildren(...rows.map(([name]) => rowOf(name, ["", ""])));
    rows.forEach(([name, ...values], k) => [name, ...values].forEach((value = "", column) => {
      write(find("numbers").rows[k].cells[column], value === null ? "∞" : typeof value === "number" ? shownNumber(value) : value);
    }));
    const [x, y] = xyOf(now.place);
    write(find("worst"), `The worst place is on face ${content.faces[now.face].number} at (${x.toFixed(1)}, ${y.toFixed(1)}) mm, at the white ball.`);
    presser.markWorst(now.face, now.place);
  }
  const xyOf = (place) => Array.from(arrays.place_xy_mm.data.subarray(2 * place, 2 * place + 2));

  function showLimits({ broken }) {
    state.broken = broken;
    const lines = broken.length ? broken.map(told) : ["All limits of instobj check are kept."];
    if (state.answer.beyond) lines.push("A part lies where the quick model knows no motions: it is judged at the nearest place that it knows.");
    find("limits").replaceChildren(...lines.map((text) => made("li", { textContent: text, className: broken.length ? "broken" : "kept" })));
    paintBroken();
    fillNumbers();
  }
  function paintBroken() {
    parts.paint(state.broken, state.chosen, oneList(state.design));
    view.redraw();
  }

  // A step that can be undone: the design before it is kept.
  function remember() {
    history.past.push(copy(state.design));
    history.future = [];
  }
  function travel(from, to) {
    history[to].push(state.design);
    state.design = history[from].pop();
    state.chosen = null;
    update();
  }
  const change = (act) => { remember(); act(state.design); update(performance.now()); };

  const take = (design) => change(() => { state.design = copy(design); state.chosen = null; });

  const oneList = ({ magnets }) => !Array.isArray(magnets.positions_mm[0][0]);
  // Lists of places: one for all faces, one for each sensed face, or one for each face of a cube.
  function listsOf({ magnets, sensors }, kind) {
    if (kind === "magnet") return oneList({ magnets }) ? [magnets.positions_mm] : magnets.positions_mm;
    return (sensors.positions_mm ??= copy(state.answer.shown.sensors_mm));
  }
  function placesOf(design, kind, face) {
    const lists = listsOf(design, kind);
    return lists[lists.length === content.faces.length ? face : (content.faces[face].number - 1) % lists.length];
  }
  const depths = () => (state.design.magnets.depth_mm ??= copy(state.answer.shown.depth_mm));
  const shownXy = ({ kind, face, number }) => placesOf(copy(state.design), kind, face)[number];

  function showPart() {
    find("undo").disabled = !history.past.length;
    find("redo").disabled = !history.future.length;
    const { chosen, design } = state;
    const magnet = chosen?.kind === "magnet";
    find("of-magnet").hidden = !magnet || !content.magnets_in_shell;
    find("of-tilt").hidden = !magnet || !content.tiltable;
    find("remove").disabled = !chosen;
    find("part").textContent = chosen ? `Part: ${magnet ? "magnet" : "chip"} ${chosen.number + 1} of face ${content.faces[chosen.face].number}` : "Part: none chosen, click one";
    find("alike").textContent = oneList(design) ? "A magnet moves alike on every face; a chip on its face alone." : "Magnets and chips move on their face alone; depth, pole and tilt are alike on every face.";
    ["x", "y"].forEach((axis, k) => setNumber(axis, chosen && shownXy(chosen)[k]));
    if (magnet) {
      setNumber("depth", (design.magnets.depth_mm ?? state.answer.shown.depth_mm)[chosen.number]);
      ["tilt-x", "tilt-y"].forEach((axis, k) => setNumber(axis, design.magnets.tilt_deg[chosen.number][k]));
      find("north").value = design.magnets.north[chosen.number];
    }
    find("grade").value = typeof design.magnets.grade === "string" ? design.magnets.grade : "";
    if (find("chip-part").value !== design.sensors.part || !find("range").options.length) {
      find("chip-part").value = design.sensors.part;
      find("range").replaceChildren(...content.chips[design.sensors.part].map((range) => new Option(`±${range} mT`, range)));
    }
    find("range").value = String(design.sensors.range_mt);
    find("disturbed").checked = design.limits.use !== STILL;
    setNumber("chip-depth", design.sensors.depth_below_core_face_mm);
    setNumber("thickness", design.shell.thickness_mm);
    find("silicone").value = design.silicone.name;
    SIZES.forEach((name, axis) => setNumber(name, design.body.size_mm[axis]));
  }
  function setNumber(name, value) {
    const box = find(name);
    box.disabled = value === null || value === undefined;
    if (document.activeElement !== box) box.value = box.disabled ? "" : String(value);
  }

  // One press, or two on a face at once.
  async function press(presses) {
    state.presses = presses;
    find("release").disabled = !presses.length;
    if (!presses.length) return presser.release();
    const force = Number(find("force").value);
    const [{ face }] = presses;
    const question = { design: state.design, face: content.faces[face].number, places: presses.map(({ place }) => place), force_n: force };
    const answer = await ask("press", question);
    if (state.presses === presses) presser.show(presses, answer, presses.map(({ place }) => xyOf(place)), force);
  }

  const on = (name, event, act) => find(name).addEventListener(event, act);
  const work = makeWork({
    find, ask, frozen: Boolean(held), now: () => ({ design: state.design, scene: content.scene, force: Number(find("force").value) }), renew: () => update(),
    take,
  });
  model?.on("change:design", () => JSON.stringify(model.get("design")) !== JSON.stringify(state.design) && take(model.get("design")));
  async function refit() {
    state.ends = null;
    if (state.pinned) state.pinned.answer = await ask("judge", question(state.pinned.design));
    update();
  }
  on("figure", "change", refit);
  on("force", "change", refit);
  on("fit", "click", () => { state.ends = null; show(); });
  on("difference", "change", show);
  on("opacity", "input", () => body.fade(Number(find("opacity").value) / 100));
  on("undo", "click", () => travel("past", "future"));
  on("redo", "click", () => travel("future", "past"));
  root.addEventListener("keydown", ({ key, ctrlKey, metaKey, target }) => (ctrlKey || metaKey) && !target.matches("input") && ({ z: find("undo"), y: find("redo") })[key]?.click());
  on("pin", "click", () => {
    state.pinned = copy({ design: state.design, answer: state.answer, used: state.used });
    find("difference").disabled = false;
    show();
  });
  on("save", "click", async () => {
    try {
      const saved = await ask("save", { design: state.design });
      const note = made("p", { className: "note", textContent: saved.comments_kept ? `Saved in ${saved.file}; its comments stayed.` : `Saved in ${saved.file}; the comments of the first file could not be kept.` });
      find("commands").replaceChildren(note, ...saved.commands.map((text) => made("code", { textContent: text })));
      find("trouble").textContent = "";
    } catch (error) {
      find("trouble").textContent = error.message;
    }
  });
  ["x", "y"].forEach((axis, k) => on(axis, "change", () => change(() => (placesOf(state.design, state.chosen.kind, state.chosen.face)[state.chosen.number][k] = Number(find(axis).value)))));
  on("depth", "change", () => change(() => (depths()[state.chosen.number] = Number(find("depth").value))));
  ["tilt-x", "tilt-y"].forEach((axis, k) => on(axis, "change", () => change(({ magnets }) => (magnets.tilt_deg[state.chosen.number][k] = Number(find(axis).value)))));
  on("north", "change", () => change(({ magnets }) => (magnets.north[state.chosen.number] = find("north").value)));
  on("grade", "change", () => change(({ magnets }) => (magnets.grade = find("grade").value || copy(first.magnets.grade))));
  on("chip-part", "change", () => change(({ sensors }) => {
    const ranges = content.chips[find("chip-part").value];
    find("range").replaceChildren(); // those of the part before
    Object.assign(sensors, { part: find("chip-part").value, range_mt: ranges.find((range) => range >= sensors.range_mt) ?? ranges.at(-1) });
  }));
  on("disturbed", "change", () => change(({ limits }) => (limits.use = !find("disturbed").checked ? STILL : first.limits.use === STILL ? MOVED : first.limits.use)));
  on("range", "change", () => change(({ sensors }) => (sensors.range_mt = Number(find("range").value))));
  on("chip-depth", "change", () => change(({ sensors }) => (sensors.depth_below_core_face_mm = Number(find("chip-depth").value))));
  on("thickness", "change", () => change(({ shell }) => (shell.thickness_mm = Number(find("thickness").value))));
  on("silicone", "change", () => change(({ silicone }) => (silicone.name = find("silicone").value)));
  SIZES.forEach((name, axis) => on(name, "change", () => change((design) => (design.body.size_mm[axis] = Number(find(name).value)))));
  on("release", "click", () => press([]));
  // A part more on every face: of its free places the one farthest from its kind that keeps all limits.
  async function addPart(kind) {
    const begun = JSON.stringify(state.design), design = copy(state.design);
    const lists = listsOf(design, kind), rooms = roomsOf(content, kind), ofFaces = lists.length === rooms.length;
    const least = [0, 1].map((axis) => Math.min(...rooms.map((room) => room[axis]))); // one list serves every face
    const free = lists.map((list, face) => freePlaces(list, content.faces[ofFaces ? face : 0], ofFaces ? rooms[face] : least));
    const given = (await limitsOf(design)).broken.map(({ text }) => text);
    if (kind === "magnet") eachMagnet(design.magnets, (list) => list.push(copy(list.at(-1))));
    lists.forEach((list, face) => list.push(free[face].shift()));
    for (;;) {
      const broken = (await limitsOf(design)).broken.filter(({ text }) => !given.includes(text));
      if (JSON.stringify(state.design) !== begun) throw new Error("Something else was changed meanwhile: add the part again.");
      if (!broken.length) return change(() => { state.design = design; });
      const named = (face) => !ofFaces || broken.some(({ faces }) => !faces.length || faces.includes(content.faces[face].number));
      lists.forEach((list, face) => named(face) && list.splice(-1, 1, free[face].shift()));
      if (lists.some((list) => !list.at(-1))) throw new Error(`No room for one more ${kind === "magnet" ? "magnet" : "chip"} on every face was found: ${told(broken[0])}`);
    }
  }
  for (const kind of ["magnet", "sensor"]) {
    on(`add-${kind}`, "click", async () => {
      adding = find(`add-${kind}`).disabled = true;
      await addPart(kind).then(() => "", ({ message }) => message).then((text) => (find("trouble").textContent = text));
      adding = find(`add-${kind}`).disabled = false;
    });
  }
  on("remove", "click", () => change((design) => {
    const { kind, number } = state.chosen;
    listsOf(design, kind).forEach((list) => list.splice(number, 1));
    if (kind === "magnet") eachMagnet(design.magnets, (list) => list.splice(number, 1));
    state.chosen = null;
  }));

  joinPointer({
    stage: root.querySelector(".stage"), canvas: find("canvas"), view, now: () => ({ body, parts, content, maps }), frozen: Boolean(held),
    choose(part) { state.chosen = part; paintBroken(); showPart(); },
    begin: remember,
    move({ kind, face, number }, xy, at) {
      placesOf(state.design, kind, face)[number] = xy;
      update(at);
    },
    press(face, x, y, second) {
      const far = Array.from({ length: places }, (_, place) => (arrays.there.data[face * places + place] ? Math.hypot(xyOf(place)[0] - x, xyOf(place)[1] - y) : Infinity));
      const there = { face, place: far.indexOf(Math.min(...far)) };
      const [first] = state.presses;
      const both = second && !held && first?.face === face && first.place !== there.place;
      press(both ? [first, there] : [there]).catch(({ message }) => (find("trouble").textContent = message));
    },
  });
  await update();
  work.watch();
  window.instobjExplore = {
    state: () => state, idle: () => !busy && !again && !checking && !adding, exact: () => content.scene.endsWith("full"), latencies: () => latencies, forget: () => (latencies.length = 0),
    where: (kind, index) => parts.where(kind, index, view), at: (kind, index) => parts.at(kind, index), dent: () => body.deepest(), map: () => Array.from(arrays.map_live.data),
  };
  root.querySelector("#instobj-explore").dataset.ready = "yes";
}

// A sentence of the check behind the names that the page has for the parts.
function told({ text, magnets, sensors }) {
  const names = [...magnets.map((number) => `magnet ${number + 1}`), ...sensors.map((number) => `chip ${number + 1}`)];
  return names.length ? `${names.join(", ")}: ${text}` : text;
}

function rowOf(name, cells) {
  const line = made("tr", {});
  line.append(made("th", { textContent: name }));
  cells.forEach((cell) => line.insertCell().append(cell));
  return line;
}

const endsOf = (values) => [Math.min(...values), Math.max(...values)];

// Lists of one entry for each magnet, but its places.
function eachMagnet(magnets, act) {
  Object.entries(magnets).forEach(([key, list]) => key !== "positions_mm" && Array.isArray(list) && act(list));
}

// Places of a coarse lattice over the face, the farthest from the others first.
function freePlaces(taken, face, room) {
  const shares = Array.from({ length: 81 }, (_, k) => [(k % 9) / 4 - 1, Math.floor(k / 9) / 4 - 1]);
  const places = shares.map((share) => share.map((part, axis) => rounded(part * Math.min(0.55 * face.half_mm[axis], room[axis]))));
  const near = (at) => Math.min(...taken.map(([x, y]) => Math.hypot(x - at[0], y - at[1])), Infinity);
  return places.sort((a, b) => near(b) - near(a));
}

function makeBody({ content, arrays }, view) {
  const skin = new MeshLambertMaterial({ color: COLOURS.silicone, transparent: true });
  const silicone = solid(geometryOf(arrays, "silicone"), skin, []);
  silicone.back.visible = false;
  silicone.front.renderOrder = 2;
  view.scene.add(silicone.group, outline(silicone.front.geometry, []));
  if (arrays.core_mm) {
    const core = new Mesh(geometryOf(arrays, "core"), new MeshLambertMaterial({ color: COLOURS.core, transparent: true, opacity: 0.35, depthWrite: false }));
    core.add(outline(core.geometry, []));
    view.scene.add(core);
  }
  content.faces.forEach((face) => addNumber(face, view));
  const fade = (share) => {
    skin.opacity = share;
    skin.depthWrite = share > 0.95;
    view.redraw();
  };
  const still = new Vector3();
  const rest = numbers(arrays.silicone_mm);
  // The skin with dents: each moves what lies round it, less so deeper down, where the core holds it.
  function bend(dents) {
    const { position } = silicone.front.geometry.attributes;
    position.array.set(rest);
    dents.forEach((dent) => push(position.array, rest, dent, content.thickness_mm));
    position.needsUpdate = true;
    silicone.front.geometry.computeVertexNormals();
  }
  // Largest displacement of the skin, mm.
  const deepest = () => silicone.front.geometry.attributes.position.array.reduce((most, value, k) => Math.max(most, Math.abs(value - rest[k])), 0);
  return { silicone, offset: () => still, fade, bend, deepest };
}

// `profile`: distance from the press, displacement inwards and away from it.
function push(position, rest, { origin, normal, profile }, thickness) {
  const [from, reach] = [new Vector3(), profile.at(-1)[0]];
  const step = profile[1][0];
  for (let v = 0; v < rest.length; v += 3) {
    from.set(rest[v] - origin.x, rest[v + 1] - origin.y, rest[v + 2] - origin.z);
    const deep = -from.dot(normal);
    const far = from.addScaledVector(normal, deep).length();
    if (far >= reach || deep >= thickness) continue;
    const k = Math.min(profile.length - 2, Math.floor(far / step));
    const [inward, outward] = [1, 2].map((c) => profile[k][c] + (far / step - k) * (profile[k + 1][c] - profile[k][c]));
    const share = 1 - Math.max(0, deep) / thickness;
    from.multiplyScalar(far ? outward / far : 0).addScaledVector(normal, -inward);
    position[v] += share * from.x;
    position[v + 1] += share * from.y;
    position[v + 2] += share * from.z;
  }
}

// All parts of a shape in one drawing: each costs a program that draws in software as much as its pixels.
// Transparent, so that they are drawn in full colour after the skin over them.
function makeCopies(view, geometry) {
  const copies = new InstancedMesh(geometry, new MeshLambertMaterial({ transparent: true, opacity: 0.9 }), MOST_PARTS);
  Object.assign(copies, { renderOrder: 3, frustumCulled: false });
  view.scene.add(copies);
  const colour = new Color();
  return (objects) => {
    copies.count = 0;
    objects.forEach((object) => {
      object.updateMatrixWorld();
      object.traverse(({ material, matrixWorld }) => {
        if (!material) return;
        copies.setColorAt(copies.count, colour.copy(material.color).add(material.emissive));
        copies.setMatrixAt(copies.count++, matrixWorld);
      });
    });
    copies.instanceMatrix.needsUpdate = true;
    if (copies.instanceColor) copies.instanceColor.needsUpdate = true;
  };
}

// Magnets and chips where the last answer has them; each knows its face and its number on it.
function makeParts(view, content) {
  const made = { magnet: [], sensor: [], board: [] };
  const pools = {
    magnet: makePool(view, () => keep("magnet", makeMagnet())), sensor: makePool(view, () => keep("sensor", boxOf(COLOURS.chip))),
    board: makePool(view, () => keep("board", boxOf(COLOURS.board))),
  };
  const boardsMove = !content.magnets_in_shell; // chips in the silicone are drawn as their boards
  let counts = {};
  function keep(kind, object) {
    object.traverse((mesh) => mesh.layers.set(GRASPED));
    object.traverse((mesh) => mesh.material && (mesh.userData.colour = mesh.material.color.getHex()));
    made[kind].push(object);
    return object;
  }
  const [disks, chips, boards] = [new CylinderGeometry(1, 1, 1, 32), new BoxGeometry(2, 2, 2), new BoxGeometry(2, 2, 2)].map((geometry) => makeCopies(view, geometry));
  const copies = { magnet: disks, sensor: chips, board: boards };
  const moving = boardsMove ? "board" : "magnet";
  let [rest, shift] = [null, null];
  function place(layout) {
    rest = layout;
    const { magnets, chips, boards } = layout;
    counts = { magnet: magnets.length, sensor: boards.length, board: boards.length };
    for (const [kind, list] of [["magnet", magnets], ["sensor", chips], ["board", boards]]) {
      pools[kind].place(list.map((one, index) => ({ ...one, ...moved(kind, index, one), half: one.half })));
    }
  }
  // Where a part stands in the press that `shift` holds: motions of a face's bodies in its frame, mm and rad.
  function moved(kind, index, { at, axes }) {
    const turn = quaternionOf(axes);
    const face = Math.floor(index / perFace(kind));
    const motion = kind === moving && shift?.face === face ? shift.motions[index % perFace(kind)] : null;
    if (!motion || motion.includes(null)) return { at, turn };
    const { x, y, normal } = content.faces[face];
    const inObject = (a, b, c) => new Vector3().addScaledVector(new Vector3(...x), a).addScaledVector(new Vector3(...y), b).addScaledVector(new Vector3(...normal), c);
    const spin = inObject(...motion.slice(3));
    const angle = spin.length();
    if (angle) turn.premultiply(new Quaternion().setFromAxisAngle(spin.divideScalar(angle), angle));
    return { at: inObject(...motion).add(new Vector3(...at)).toArray(), turn };
  }
  function move(press) {
    shift = press;
    if (rest) place(rest);
  }
  const signs = makePool(view, () => label("!", 1, "#e01b24"));
  let limits = [];
  const perFace = (kind) => counts[kind] / content.faces.length;
  const shown = (kind) => (kind === "sensor" && boardsMove ? made.board : made[kind]).slice(0, counts[kind]);
  const faceOf = (kind, index) => content.faces[Math.floor(index / perFace(kind))];
  const isBroken = (kind, index) => limits.some((one) => one[`${kind}s`].includes(index % perFace(kind)) && (!one.faces.length || one.faces.includes(faceOf(kind, index).number)));
  // Parts of faces that look away are left out: they would seem to lie in front.
  view.before.push((camera) => {
    for (const kind of ["magnet", "sensor", "board"]) {
      made[kind].slice(0, counts[kind]).forEach((object, index) => (object.visible = facing(faceOf(kind, index), camera)));
      copies[kind](made[kind].filter(({ visible }) => visible));
    }
    const marked = ["magnet", "sensor"].flatMap((kind) => shown(kind).filter((one, index) => one.visible && isBroken(kind, index)));
    signs.place(marked.map((one) => ({ at: one.position.toArray(), turn: one.quaternion, half: Array(3).fill(view.size / 6) })));
  });
  // Broken parts red, the chosen one bright; magnets of one list are alike on every face.
  function paint(broken, chosen, oneList) {
    limits = broken;
    for (const kind of ["magnet", "sensor"]) {
      shown(kind).forEach((object, index) => {
        const here = chosen?.kind === kind && chosen.number === index % perFace(kind) && (faceOf(kind, index) === content.faces[chosen.face] || (kind === "magnet" && oneList));
        const red = isBroken(kind, index);
        object.traverse((mesh) => {
          mesh.material?.color.setHex(red ? RED : mesh.userData.colour);
          mesh.material?.emissive.setHex(red ? 0x600000 : here ? 0x554400 : 0);
        });
      });
    }
  }
  // The nearest part that a ray meets.
  function under(caster) {
    const hits = ["magnet", "sensor"].flatMap((kind) => {
      const objects = shown(kind).filter((object) => object.visible);
      return caster.intersectObjects(objects, true).map((hit) => ({ ...hit, kind, index: shown(kind).findIndex((one) => one === hit.object || one === hit.object.parent) }));
    });
    const [hit] = hits.filter(({ index }) => index >= 0).sort((a, b) => a.distance - b.distance);
    return hit && { kind: hit.kind, face: Math.floor(hit.index / perFace(hit.kind)), number: hit.index % perFace(hit.kind), at: shown(hit.kind)[hit.index].position.clone() };
  }
  // Middle of a part in the window, px.
  function where(kind, index, { camera, renderer }) {
    const box = renderer.domElement.getBoundingClientRect();
    const at = shown(kind)[index].position.clone().project(camera);
    return [box.left + ((at.x + 1) / 2) * box.width, box.top + ((1 - at.y) / 2) * box.height];
  }
  const at = (kind, index) => shown(kind)[index].position.toArray();
  return { place, move, paint, under, where, at };
}

function joinPointer({ stage, canvas, view, now, frozen, choose, begin, move, press }) {
  const caster = new Raycaster();
  caster.layers.enable(GRASPED);
  const [plane, at] = [new Plane(), new Vector3()];
  let drag = null;
  function aim(event) {
    const box = canvas.getBoundingClientRect();
    caster.setFromCamera(new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2), view.camera);
  }
  function pressUnder(second) {
    const { body, content, maps } = now();
    const [hit] = caster.intersectObject(body.silicone.front, false);
    const face = hit ? Math.max(...[hit.face.a, hit.face.b, hit.face.c].map((v) => maps.owner[v])) : -1;
    if (face >= 0) press(face, ...placeOn(content.faces[face], hit.point.x, hit.point.y, hit.point.z), second);
  }
  // Before the camera's own listener on the canvas hears of it.
  stage.addEventListener("pointerdown", (event) => {
    if (event.target !== canvas || event.button) return;
    aim(event);
    if (event.shiftKey) {
      event.stopPropagation();
      return pressUnder(event.altKey);
    }
    const { parts, content } = now();
    const found = !frozen && parts.under(caster);
    if (!found) return;
    event.stopPropagation();
    const normal = new Vector3(...content.faces[found.face].normal);
    plane.setFromNormalAndCoplanarPoint(normal, found.at);
    caster.ray.intersectPlane(plane, at);
    drag = { ...found, from: [event.clientX, event.clientY], off: found.at.sub(at), moved: false };
    choose({ kind: found.kind, face: found.face, number: found.number });
    canvas.setPointerCapture(event.pointerId);
  }, true);
  canvas.addEventListener("pointermove", (event) => {
    if (!drag) return;
    if (!drag.moved && Math.hypot(event.clientX - drag.from[0], event.clientY - drag.from[1]) < MOVED_PX) return;
    aim(event);
    if (!caster.ray.intersectPlane(plane, at)) return;
    if (!drag.moved) begin();
    drag.moved = true;
    const face = now().content.faces[drag.face];
    const local = at.add(drag.off).sub(new Vector3(...face.centre_mm));
    const room = roomsOf(now().content, drag.kind)[drag.face];
    const xy = [face.x, face.y].map((axis, k) => rounded(Math.min(room[k], Math.max(-room[k], local.dot(new Vector3(...axis))))));
    move(drag, xy, event.timeStamp);
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (drag = null));
}

if (document.querySelector("body > #instobj-explore")) { // a notebook's widget is started by anywidget
  startExplore(document.body).catch((error) => {
    document.querySelector('[data-name="trouble"]').textContent = `The page cannot start: ${error.message}.`;
    console.warn(error);
  });
}
