// The state of the page, which a link restores. It is frozen: who changes it says so here, and who shows it is told.

const isObject = (value) => value !== null && typeof value === 'object';

const isGroup = (value) => isObject(value) && !Array.isArray(value);

function freeze(value) {
  if (isObject(value)) Object.values(Object.freeze(value)).forEach(freeze);
  return value;
}

function isSame(a, b) {
  if (!isObject(a) || !isObject(b)) return Object.is(a, b);
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => isSame(a[name], b[name]));
}

export class Store {
  constructor(state) {
    this.state = freeze(state);
    this.views = new Set();
  }

  // `values` come in the place of those of the state; of a group, as `look`, those that are named. Views get the state and the
  // names of what has changed, if anything has.
  set(values) {
    const next = { ...this.state };
    for (const [name, value] of Object.entries(values)) next[name] = isGroup(value) ? { ...next[name], ...value } : value;
    const changed = Object.keys(values).filter((name) => !isSame(next[name], this.state[name]));
    if (changed.length === 0) return;
    this.state = freeze(next);
    for (const view of this.views) view(this.state, changed);
  }

  // Returns what ends it.
  subscribe(view) {
    this.views.add(view);
    return () => this.views.delete(view);
  }
}
