// Numbers at random that are the same in each run.
export function generator(seed) {
  let x = seed;
  const next = () => {
    x = (Math.imul(x, 1664525) + 1013904223) >>> 0;
    return x / 2 ** 32;
  };
  const below = (n) => Math.floor(n * next());
  const pick = (list) => list[below(list.length)];
  return { next, below, pick };
}
