// The link that the page was opened by, and what of it could not be followed, in words.

export class Link {
  // `ignored` are names of what it says and the page does not understand.
  constructor(ignored = []) {
    this.notes = [];
    const names = [...new Set(ignored)].map((name) => `“${name}”`);
    if (names.length > 0) this.add(`Of this link, ${names.join(', ')} ${names.length === 1 ? 'is' : 'are'} not understood, and left as usual.`);
  }

  add(note) {
    this.notes.push(note);
  }
}
