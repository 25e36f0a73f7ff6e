// The archive that instobj/viewer/archive.py writes: a JSON head and arrays of small integers.
const KINDS = {
  i1: Int8Array, u1: Uint8Array, i2: Int16Array, u2: Uint16Array, u4: Uint32Array, f4: Float32Array,
};

export function bytesOf(base64) {
  return Uint8Array.from(atob(base64.trim()), (letter) => letter.charCodeAt(0));
}

export async function readArchive(packed) {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const raw = await new Response(stream).arrayBuffer();
  const size = new DataView(raw).getUint32(0, true);
  const content = JSON.parse(new TextDecoder().decode(new Uint8Array(raw, 4, size)));
  const arrays = {};
  for (const [name, entry] of Object.entries(content.arrays)) {
    const count = entry.shape.reduce((a, b) => a * b, 1);
    const data = new KINDS[entry.kind](raw, 4 + size + entry.at, count);
    const none = { i1: 127, i2: 32767 }[entry.kind];
    arrays[name] = { data, shape: entry.shape, step: entry.step, none: entry.gaps ? none : null };
  }
  return { content, arrays };
}

// Every value of an array as a number; NaN where there is none.
export function numbers(array) {
  return Float32Array.from(array.data, (v) => (v === array.none ? NaN : v * array.step));
}

// One row of an array whose last axes hold `length` numbers.
export function row(array, index, length) {
  const found = [];
  for (let i = index * length; i < (index + 1) * length; i++) found.push(array.data[i] * array.step);
  return found;
}
