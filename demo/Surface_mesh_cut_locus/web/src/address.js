// Keeps what is seen in the address, as a link. Safari throws after 100 changes of it in 30 seconds, and other browsers drop
// some: there is at most one in a third of a second, and the last one always comes.

const apart = 350; // milliseconds

export class Address {
  // `write` changes the address; what it throws only means that a link is old.
  constructor(write) {
    this.write = write;
    this.written = -Infinity; // when
    this.waiting = null;
  }

  set(hash) {
    this.waiting = hash;
    const rest = this.written + apart - performance.now();
    if (rest <= 0) this.flush();
    else this.timer ||= setTimeout(() => this.flush(), rest);
  }

  // What waits is written now.
  flush() {
    clearTimeout(this.timer);
    this.timer = null;
    if (this.waiting === null) return;
    this.written = performance.now();
    try {
      this.write(this.waiting);
    } catch {
      // the next one may be taken
    }
    this.waiting = null;
  }
}
