// Small things that the browser remembers for whoever looks at the page, if it is allowed to.

const prefix = 'cut-locus-';

export function recall(name) {
  try {
    return localStorage.getItem(prefix + name);
  } catch {
    return null;
  }
}

export function remember(name, value) {
  try {
    localStorage.setItem(prefix + name, value);
  } catch {
    // then it is asked, or told, again
  }
}
