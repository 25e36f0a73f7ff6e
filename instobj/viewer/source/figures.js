// What the live page measures of itself over the last minute, times in ms.
const SPAN_MS = 60_000;
const RECENT_MS = 3000;

// Values with the times they belong to; those older than the span leave.
function makeRecord() {
  let kept = [];
  return {
    note(value, at = performance.now()) {
      kept.push([at, value]);
      if (kept[0][0] < at - SPAN_MS) kept = kept.filter(([then]) => then >= at - SPAN_MS);
    },
    values: () => kept.map(([, value]) => value),
    since: (at) => kept.filter(([then]) => then >= at).map(([then]) => then),
    forget: () => (kept = []),
  };
}

function shares(values) {
  const sorted = values.sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  return { count: sorted.length, p50: at(0.5), p90: at(0.9), p99: at(0.99), most: sorted.at(-1) };
}

export function makeFigures() {
  const [latency, age, work, underway] = [makeRecord(), makeRecord(), makeRecord(), makeRecord()];
  const counts = { shown: 0, messages: 0, rows: 0, dropped: 0 };
  const now = () => performance.timeOrigin + performance.now();
  const arrival = ({ readS, arrivedS }) => 1000 * (readS || arrivedS);
  function came(message) {
    const { rows, dropped } = message;
    underway.note(now() - arrival(message));
    counts.messages += 1;
    counts.rows += rows;
    counts.dropped = dropped;
  }
  function drawn(spentMs) {
    counts.shown += 1;
    work.note(spentMs);
  }
  // A message whose picture is on the screen: how old are its contacts, and its newest row?
  function seen(message) {
    latency.note(now() - arrival(message));
    age.note(now() - 1000 * message.arrivedS);
  }
  function told() {
    const recent = work.since(performance.now() - RECENT_MS);
    const perSecond = recent.length > 1 ? (1000 * (recent.length - 1)) / (recent.at(-1) - recent[0]) : 0;
    return { ...counts, perSecond, latencyMs: shares(latency.values()), underwayMs: shares(underway.values()), ageMs: shares(age.values()), workMs: shares(work.values()) };
  }
  function forget() {
    [latency, age, work, underway].forEach((one) => one.forget());
    Object.assign(counts, { shown: 0, messages: 0, rows: 0 });
  }
  return { came, drawn, seen, told, forget };
}
