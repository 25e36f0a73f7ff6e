// Two objectives of every trial; a click on one of the front shows its layout.
import { addTo } from "./bars.js";
import { shownNumber } from "./maps.js";

const LEAST = 1e-6; // scores of 0 have no logarithm
const [WIDE, HIGH, LEFT, LOW] = [300, 230, 46, 40];

export function drawFront(svg, { objectives, trials, layouts }, choose) {
  svg.setAttribute("viewBox", `0 0 ${WIDE} ${HIGH}`);
  const shown = layouts.map((one, index) => [...one.scores.slice(0, 2), index]).filter((pair) => !pair.includes(null));
  const log = (value) => Math.log(Math.max(value, LEAST));
  const ends = [0, 1].map((axis) => {
    const logs = [...trials, ...shown].map((pair) => log(pair[axis]));
    return [Math.min(...logs), Math.max(...logs)];
  });
  const share = (value, axis) => (log(value) - ends[axis][0]) / (ends[axis][1] - ends[axis][0] || 1);
  const x = (value) => LEFT + 8 + share(value, 0) * (WIDE - LEFT - 16);
  const y = (value) => HIGH - LOW - 8 - share(value, 1) * (HIGH - LOW - 16);
  const text = (content, more) => addTo(svg, "text", { "font-size": 9, fill: "#444", ...more }, content);
  addTo(svg, "path", { d: `M${LEFT} 0V${HIGH - LOW}H${WIDE}`, fill: "none", stroke: "#555" });
  for (const part of [0, 0.5, 1]) {
    const [a, b] = ends.map(([low, high]) => Math.exp(low + part * (high - low)));
    text(shownNumber(a), { x: x(a), y: HIGH - LOW + 12, "text-anchor": "middle" });
    text(shownNumber(b), { x: LEFT - 4, y: y(b) + 3, "text-anchor": "end" });
  }
  text(objectives[0], { x: WIDE, y: HIGH - 12, "text-anchor": "end" });
  text(objectives[1], { x: 0, y: 0, "text-anchor": "end", transform: "translate(9 0) rotate(-90)" });
  for (const [a, b] of trials) addTo(svg, "circle", { cx: x(a), cy: y(b), r: 1.6, fill: "#9a968d" });
  const marks = shown.map(([a, b, index]) => {
    const mark = index
      ? addTo(svg, "circle", { cx: x(a), cy: y(b), r: 4.5, stroke: "#1652b8", "stroke-width": 1.5, class: "choice", "data-layout": index })
      : addTo(svg, "path", { d: `M${x(a) - 4} ${y(b) - 4}l8 8m0 -8l-8 8`, stroke: "#1c1c1c", "stroke-width": 2 });
    addTo(mark, "title", {}, `${layouts[index].label}: ${shownNumber(a)}, ${shownNumber(b)}`);
    if (index) mark.addEventListener("click", () => choose(index));
    return mark;
  });
  const mark = (chosen) => marks.forEach((one) => one.setAttribute("fill", Number(one.dataset.layout) === chosen ? "#1652b8" : "#fff"));
  return { mark };
}
