// Long work of the explorer's page: a search from the layout, the whole chain, mechanics of a new shell.
import { shownNumber } from "./maps.js";

const AGAIN_MS = 1000;
const made = (tag, properties) => Object.assign(document.createElement(tag), properties);

export function makeWork({ find, ask, frozen, now, renew, take }) {
  let [watching, more, confirming] = [false, false, null];
  let listed = "";

  // Until nothing is at work any more; what was begun meanwhile is asked for once more.
  async function watch() {
    more = true;
    if (frozen || watching) return;
    watching = true;
    try {
      for (;;) {
        more = false;
        const told = await ask("state", { design: now().design });
        show(told);
        if (told.scene !== now().scene) renew();
        if (!told.work.running && confirming) await showConfirmed();
        if (!told.refining && !told.work.running && !more) break;
        await new Promise((done) => setTimeout(done, AGAIN_MS));
      }
    } catch (error) {
      find("trouble").textContent = error.message;
    }
    watching = false;
  }
  function show({ refined, work }) {
    find("refined").textContent = refined;
    find("improve").disabled = find("confirm").disabled = work.running;
    find("stop").disabled = !work.running;
    find("work-command").textContent = work.command;
    find("work-line").textContent = work.command && `${work.running ? "at work" : work.failed ? "ended early" : "finished"}${work.line ? `: ${work.line}` : ""}`;
    const text = JSON.stringify(work.layouts);
    if (text === listed) return; // buttons stay under the hand
    listed = text;
    find("layouts").replaceChildren(...work.layouts.map(({ label, design }) => {
      const line = made("li", { textContent: `${label} ` });
      line.append(made("button", { type: "button", textContent: "take", onclick: () => take(design) }));
      return line;
    }));
  }
  async function showConfirmed() {
    const { rows, channels } = await ask("confirmed", confirming);
    confirming = null;
    const ratio = ({ page, chain }) => (page === null || chain === null ? "–" : shownNumber(chain / page));
    find("confirmed").replaceChildren(...rows.map((one) => {
      const line = made("tr", {});
      line.append(made("th", { textContent: one.name }));
      [one.page, one.chain].forEach((value) => line.insertCell().append(value === null ? "∞" : shownNumber(value)));
      line.insertCell().append(ratio(one));
      return line;
    }));
    find("confirmed-head").hidden = !rows.length;
    find("confirmed-note").textContent = rows.length && channels === "all" ? "The chain reads the chips of all faces, the page those of the pressed face: part of the difference." : "";
  }
  async function begin(question, also) {
    try {
      const { design, force: force_n } = now();
      await ask(question, { design, force_n, ...also });
      find("trouble").textContent = "";
      if (question === "confirm") confirming = { design, force_n };
      await watch();
    } catch (error) {
      find("trouble").textContent = error.message;
    }
  }
  find("improve").addEventListener("click", () => begin("improve", { seconds: Number(find("seconds").value) }));
  find("confirm").addEventListener("click", () => begin("confirm", {}));
  find("stop").addEventListener("click", () => begin("stop", {}));
  return { watch };
}
