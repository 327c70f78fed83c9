// Joins segments to polylines: from one end or branching to the next, and around loops.

export function chainsOf(segments) {
  const keyAt = (i) => `${segments[i]},${segments[i + 1]},${segments[i + 2]}`;
  const ends = new Map(); // of each point, the segments there
  const add = (key, segment) => (ends.has(key) ? ends.get(key).push(segment) : ends.set(key, [segment]));
  const count = segments.length / 6;
  for (let s = 0; s < count; ++s) {
    add(keyAt(6 * s), s);
    add(keyAt(6 * s + 3), s);
  }
  const isTaken = new Uint8Array(count);
  const pointAt = (i) => [segments[i], segments[i + 1], segments[i + 2]];

  // along segment s, from its end at index i of `segments`
  const walk = (first, start) => {
    const chain = [pointAt(start)];
    for (let s = first, i = start; ;) {
      isTaken[s] = 1;
      const other = i === 6 * s ? 6 * s + 3 : 6 * s;
      chain.push(pointAt(other));
      const key = keyAt(other);
      const next = ends.get(key).length === 2 ? ends.get(key).find((t) => !isTaken[t]) : undefined;
      if (next === undefined) return chain;
      s = next;
      i = keyAt(6 * s) === key ? 6 * s : 6 * s + 3;
    }
  };
  const chains = [];
  for (let s = 0; s < count; ++s)
    for (const i of [6 * s, 6 * s + 3])
      if (!isTaken[s] && ends.get(keyAt(i)).length !== 2) chains.push(walk(s, i));
  for (let s = 0; s < count; ++s) if (!isTaken[s]) chains.push(walk(s, 6 * s)); // loops
  return chains;
}
