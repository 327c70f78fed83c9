// The wave that runs from the sources over the surface, and stops where its fronts meet: a share of the way to the farthest
// point, which grows while it plays. At its end, all is shown as usual.

const duration = 5000; // milliseconds

export class Wave {
  // `show` draws it, and tells its state: a share in [0, 1], 1 if there is no wave, and whether it plays.
  constructor(show, nextFrame = (action) => requestAnimationFrame(action)) {
    this.show = show;
    this.nextFrame = nextFrame;
    this.share = 1;
    this.isPlaying = false;
  }

  // From where it is, or again from the start.
  play() {
    if (this.isPlaying) return;
    if (this.share >= 1) this.share = 0;
    this.isPlaying = true;
    this.last = null;
    this.tell();
    this.nextFrame((now) => this.step(now));
  }

  step(now) {
    if (!this.isPlaying) return;
    // where frames take long, or the page has been hidden, it does not jump
    if (this.last !== null) this.share = Math.min(this.share + Math.min(now - this.last, 200) / duration, 1);
    this.last = now;
    this.isPlaying = this.share < 1;
    this.tell();
    if (this.isPlaying) this.nextFrame((then) => this.step(then));
  }

  pause() {
    this.isPlaying = false;
    this.tell();
  }

  toggle() {
    if (this.isPlaying) this.pause();
    else this.play();
  }

  // to a share, where it stays
  moveTo(share) {
    this.isPlaying = false;
    this.share = Math.min(Math.max(share, 0), 1);
    this.tell();
  }

  // Other sources: what has been shown is no wave of theirs.
  end() {
    if (this.share >= 1 && !this.isPlaying) return;
    this.moveTo(1);
  }

  tell() {
    this.show(this.share, this.isPlaying);
  }
}
