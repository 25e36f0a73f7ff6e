// Changes of every channel as bars, in counts against their noise, and the same as a table.
const SVG = "http://www.w3.org/2000/svg";

const COLOURS = ["#b3261e", "#2e7d32", "#1652b8"];
const [WIDE, LEFT, HIGH, GAP] = [300, 62, 5, 4];
const MOST = 32768;

export function addTo(parent, name, attributes, text) {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== undefined) node.textContent = text;
  parent.append(node);
  return node;
}

// Linear within the noise, logarithmic beyond it.
function along(count, noise) {
  const half = (WIDE - LEFT) / 2;
  return LEFT + half + (Math.sign(count) * half * Math.asinh(Math.abs(count) / noise)) / Math.asinh(MOST / noise);
}

export function drawBars(svg, signals) {
  svg.replaceChildren();
  const row = 3 * HIGH + GAP;
  const high = signals.length * row + GAP + 20;
  svg.setAttribute("viewBox", `0 0 ${WIDE} ${high}`);
  const noise = Math.min(...signals[0].noise);
  for (const count of [-1e4, -1e3, -100, 0, 100, 1e3, 1e4]) {
    const x = along(count, noise);
    addTo(svg, "line", { x1: x, x2: x, y1: 0, y2: high - 18, stroke: count ? "#e2e2dc" : "#555" });
    const text = Math.abs(count) >= 1e3 ? `${count / 1e3}k` : `${count}`;
    addTo(svg, "text", { x, y: high - 6, "font-size": 9, "text-anchor": "middle", fill: "#555" }, text.replace("-", "−"));
  }
  signals.forEach(({ face, counts, live, noise: sigma, number }, index) => {
    const y = index * row + GAP;
    addTo(svg, "text", { x: 0, y: y + 12, "font-size": 10, fill: "#333" }, `F${face}-S${number}`);
    counts.forEach((count, axis) => {
      if (!live[axis]) return;
      const [zero, band, end] = [along(0, noise), along(sigma[axis], noise), along(count, noise)];
      const at = y + axis * HIGH + 1;
      addTo(svg, "rect", { x: 2 * zero - band, width: 2 * (band - zero), y: at, height: HIGH - 1, fill: "#d9d9d2" });
      const bar = { x: Math.min(zero, end), width: Math.abs(end - zero), y: at, height: HIGH - 1.5, fill: COLOURS[axis] };
      addTo(svg, "rect", { ...bar, opacity: Math.abs(count) < sigma[axis] ? 0.35 : 1 });
    });
  });
}

export function fillTable(body, signals) {
  body.replaceChildren(...signals.map(({ face, number, counts, live }) => {
    const line = document.createElement("tr");
    const cells = [face, number, ...counts.map((count, a) => (live[a] ? Math.round(count) : "–"))];
    cells.forEach((cell) => line.insertCell().append(String(cell)));
    return line;
  }));
}

