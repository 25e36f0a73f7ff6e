// How far the body is from the camera, on a coarse grid: what lies behind it is hidden.
const WIDE = 192;

export function makeDepthMap(geometry) {
  const position = geometry.attributes.position.array;
  const corners = geometry.index.array;
  const seen = new Float32Array(position.length); // column, row and 1 / distance of every vertex
  let [wide, high] = [0, 0];
  let nearest = new Float32Array(0);

  // `project` writes column and row as shares of the picture, and the distance.
  function draw(project, aspect) {
    [wide, high] = [WIDE, Math.max(1, Math.round(WIDE / aspect))];
    if (nearest.length !== wide * high) nearest = new Float32Array(wide * high);
    nearest.fill(0);
    const at = [0, 0, 0];
    for (let v = 0; v < position.length; v += 3) {
      project(position[v], position[v + 1], position[v + 2], at);
      seen[v] = at[0] * wide;
      seen[v + 1] = at[1] * high;
      seen[v + 2] = 1 / at[2];
    }
    for (let t = 0; t < corners.length; t += 3) fill(3 * corners[t], 3 * corners[t + 1], 3 * corners[t + 2]);
  }
  function fill(a, b, c) {
    const [ax, ay, bx, by, cx, cy] = [seen[a], seen[a + 1], seen[b], seen[b + 1], seen[c], seen[c + 1]];
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (area >= 0) return; // turned away: rows run downwards
    const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5));
    const right = Math.min(wide - 1, Math.floor(Math.max(ax, bx, cx) - 0.5));
    const top = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
    const low = Math.min(high - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
    for (let row = top; row <= low; row++) {
      for (let column = left; column <= right; column++) {
        const [x, y] = [column + 0.5, row + 0.5];
        const atB = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
        const atC = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
        if (atB < 0 || atC < 0 || atB + atC > 1) continue;
        const near = seen[a + 2] + atB * (seen[b + 2] - seen[a + 2]) + atC * (seen[c + 2] - seen[a + 2]);
        const cell = row * wide + column;
        if (near > nearest[cell]) nearest[cell] = near;
      }
    }
  }
  // Whether the body lies at least `clear` in front of a point.
  function hides(across, down, distance, clear) {
    const [column, row] = [Math.floor(across * wide), Math.floor(down * high)];
    if (column < 0 || row < 0 || column >= wide || row >= high) return false;
    const near = nearest[row * wide + column];
    return near > 0 && 1 / near < distance - clear;
  }
  return { draw, hides };
}
