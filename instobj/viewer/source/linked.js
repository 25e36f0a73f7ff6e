// Several objects beside each other: one camera, one press (place, depth), one colour scale.
const LINKED = ["map", "explode", "opacity", "clip-axis", "clip", "opening"];

export function linkViews(views) {
  let busy = false;
  // What one view does to the others must not come back.
  const follow = (one, act) => {
    if (busy) return;
    busy = true;
    try {
      views.filter((other) => other !== one).forEach(act);
    } finally {
      busy = false;
    }
  };
  shareScales(views);
  for (const one of views) {
    one.watchers.push(() => follow(one, (other) => followPress(one, other)));
    one.view.controls.addEventListener("change", () => follow(one, (other) => followCamera(one, other)));
    for (const kind of ["input", "change"]) {
      one.host.addEventListener(kind, (event) => follow(one, (other) => followControl(event, other)));
    }
    one.find("open").addEventListener("click", () => follow(one, (other) => other.find("open").click()));
  }
  const largest = views.reduce((a, b) => (a.view.size >= b.view.size ? a : b));
  follow(largest, (other) => followCamera(largest, other));
  follow(views[0], (other) => followPress(views[0], other));
}

// The same face by its number, the contact location and the depth nearest to the other's.
function followPress(one, other) {
  const { face, place, step } = one.press.state;
  const number = one.content.faces[face].number;
  const found = other.content.faces.findIndex((candidate) => candidate.number === number);
  if (found < 0) return;
  const [x, y] = one.press.xy(place);
  const depth = step ? one.press.depths[step - 1] : 0;
  const ways = [0, ...other.press.depths].map((candidate) => Math.abs(candidate - depth));
  other.choose(found, other.near(found, x, y), ways.indexOf(Math.min(...ways)));
}

// The same place in mm, so that sizes can be compared.
function followCamera(one, other) {
  other.view.controls.target.copy(one.view.controls.target);
  other.view.camera.position.copy(one.view.camera.position);
  other.view.controls.update();
  other.view.redraw();
}

function followControl(event, other) {
  const { name } = event.target.dataset;
  if (event.target.type === "radio") {
    const same = other.host.querySelector(`[type=radio][value="${event.target.value}"]`);
    if (same.closest("label").hidden) return;
    same.checked = true;
    same.dispatchEvent(new Event(event.type));
  } else if (LINKED.includes(name)) {
    other.find(name).value = event.target.value;
    other.find(name).dispatchEvent(new Event(event.type));
  }
}

function shareScales(views) {
  for (const { stem } of views[0].content.maps) {
    const maps = views.map((one) => one.content.maps.find((map) => map.stem === stem));
    const ends = views.map((one, index) => one.maps.endsOf(maps[index]));
    const joint = [Math.min(...ends.map(([low]) => low)), Math.max(...ends.map(([, high]) => high))];
    views.forEach((one) => one.maps.fix(stem, joint));
  }
}
