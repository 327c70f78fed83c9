// Where keys set a source, or ask for values: in the middle of what is looked at, or, if there is a hole, at the point of the
// surface that is seen nearest to it. It shows while the view has the focus by the keyboard.

const restMilliseconds = 120; // the nearest point is looked for when the view rests
const nearPixels = 3; // a target that is as near is that of the crosshair itself

export class Crosshair {
  constructor(viewer, cross, target) {
    this.viewer = viewer;
    this.cross = cross;
    this.target = target;
    const { element } = viewer.model;
    for (const type of ['focus', 'blur', 'pointerdown', 'keydown'])
      element.addEventListener(type, () => this.show(element.matches(':focus-visible')));
    this.place = () => this.placeBoth();
  }

  show(isShown) {
    if (this.isShown === isShown) return;
    this.isShown = isShown;
    clearTimeout(this.timer);
    this.cross.hidden = !isShown;
    this.target.hidden = true;
    if (isShown) this.viewer.afterDraw.add(this.place);
    else this.viewer.afterDraw.delete(this.place);
    if (isShown) this.placeBoth();
  }

  // the pixel of what is looked at
  get middle() {
    return this.viewer.pixelAt(this.viewer.controls.target);
  }

  locate() {
    return this.viewer.pointer.nearestSeen(...this.middle);
  }

  // to be shown beside it, by where that is on the page
  showValues(show) {
    const found = this.locate();
    if (!found) return;
    const box = this.viewer.canvas.getBoundingClientRect();
    const [x, y] = this.viewer.pixelAt(found.place);
    show(found, [box.left + x, box.top + y]);
  }

  placeBoth() {
    this.put(this.cross, this.middle);
    this.target.hidden = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.placeTarget(), restMilliseconds);
  }

  placeTarget() {
    const found = this.locate();
    if (!found) return;
    const at = this.viewer.pixelAt(found.place);
    this.target.hidden = Math.hypot(...at.map((x, k) => x - this.middle[k])) < nearPixels;
    this.put(this.target, at);
  }

  put(element, [x, y]) {
    element.style.left = `${x}px`;
    element.style.top = `${y}px`;
  }
}
