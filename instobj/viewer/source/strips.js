// Strips of the last 30 s: forces of every face, and changes of one face's channels.
import uPlot from "uplot";

const SPAN_S = 30;
const EVERY_MS = 200;
const MOST = 16384;
const COLOURS = ["#b3261e", "#2e7d32", "#1652b8", "#e07a5f", "#66a182", "#7aa5e8", "#7a1811", "#14532d", "#0b2e6b", "#444", "#888", "#d81b9a"];

// A ring of rows: time, then numbers.
function makeRing(wide) {
  const columns = Array.from({ length: wide + 1 }, () => new Float64Array(MOST));
  let [count, next] = [0, 0];
  function push(time, values) {
    const before = columns[0][(next + MOST - 1) % MOST];
    if (count && (time < before || time - before > SPAN_S)) count = 0;
    columns[0][next] = time;
    for (let k = 0; k < wide; k++) columns[k + 1][next] = values[k];
    next = (next + 1) % MOST;
    count = Math.min(count + 1, MOST);
  }
  // The chosen columns over the last 30 s, times against the newest.
  function last(chosen) {
    if (!count) return [[], ...chosen.map(() => [])];
    const newest = columns[0][(next + MOST - 1) % MOST];
    let length = 0;
    while (length < count && newest - columns[0][(next + MOST - 1 - length) % MOST] <= SPAN_S) length += 1;
    const first = next - length + MOST;
    const taken = (column, make) => Array.from({ length }, (_, k) => make(column[(first + k) % MOST]));
    const number = (value) => (Number.isNaN(value) ? null : value);
    return [taken(columns[0], (t) => t - newest), ...chosen.map((k) => taken(columns[k + 1], number))];
  }
  return { push, last };
}

function makePlot(host, names, high) {
  const axis = { font: "11px system-ui", size: 34, stroke: "#555", grid: { stroke: "#e8e8e2" } };
  const series = names.map((label, k) => ({ label, stroke: COLOURS[k % COLOURS.length], width: 1, points: { show: false } }));
  const options = {
    width: host.clientWidth || 420,
    height: high,
    cursor: { show: false },
    scales: { x: { time: false, range: [-SPAN_S, 0] } },
    axes: [axis, { ...axis, size: 48 }],
    series: [{ label: "s" }, ...series],
  };
  const plot = new uPlot(options, [[], ...names.map(() => [])], host);
  new ResizeObserver(() => plot.setSize({ width: host.clientWidth, height: high })).observe(host);
  return plot;
}

export function makeStrips(find, channels, faces) {
  const all = makeRing(channels.length);
  const forces = makeRing(faces.length);
  const forcePlot = makePlot(find("forces"), faces.map((face) => `face ${face}`), 130);
  find("face").append(...faces.map((face) => new Option(face, face)));
  let chosen, plot;
  function choose() {
    const face = find("face").value;
    chosen = channels.flatMap((name, k) => (name.startsWith(`F${face}-`) ? [k] : []));
    plot?.destroy();
    find("channels").replaceChildren();
    plot = makePlot(find("channels"), chosen.map((k) => channels[k].slice(3)), 170);
  }
  find("face").addEventListener("change", choose);
  choose();

  function take({ rows, wide, values, timeS, contacts }) {
    for (let row = 0; row < rows; row++) {
      const at = row * wide;
      all.push(timeS + values[at], values.subarray(at + 1, at + wide));
    }
    forces.push(timeS, faces.map((face) => contacts.reduce((sum, one) => (one.face === face ? sum + one.force : sum), 0)));
  }
  let drawnAt = 0;
  function draw(at) {
    if (at - drawnAt < EVERY_MS) return;
    drawnAt = at;
    plot.setData(all.last(chosen));
    forcePlot.setData(forces.last(faces.map((_, k) => k)));
  }
  return { take, draw };
}
