// Messages of the live server, as instobj/bench/live/protocol.py describes them.
const HEAD = 40;
const CONTACT = 15;
const LABEL = 10;

const magic = (view) => String.fromCharCode(...[0, 1, 2, 3].map((at) => view.getUint8(at)));

export function readMessage(data, channels) {
  const view = new DataView(data);
  if (magic(view) === "IOS1") return { state: JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4))) };
  const [rows, found, told] = [view.getUint16(4, true), view.getUint8(6), view.getUint8(7)];
  const values = new Float32Array(data, HEAD);
  const wide = 1 + channels;
  const table = (count, width, from, make) => Array.from({ length: count }, (_, k) => make(values.subarray(from + k * width, from + (k + 1) * width)));
  return {
    number: view.getUint32(8, true),
    dropped: view.getUint32(12, true),
    arrivedS: view.getFloat64(16, true),
    readS: view.getFloat64(24, true),
    timeS: view.getFloat64(32, true),
    rows,
    values,
    wide,
    contacts: table(found, CONTACT, rows * wide, ([face, x, y, radius, force, halfwidth, ...v]) => ({ face, x, y, radius, force, halfwidth, point: v.slice(0, 3), normal: v.slice(3, 6), pull: v.slice(6, 9) })),
    labels: table(told, LABEL, rows * wide + found * CONTACT, ([face, x, y, force, ...v]) => ({ face, x, y, force, point: v.slice(0, 3), normal: v.slice(3, 6) })),
  };
}
