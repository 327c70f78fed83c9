// A word beside the source on the first screen: that it can be dragged. It goes with the first press.

export class DragHint {
  constructor(viewer, element) {
    this.viewer = viewer;
    this.element = element;
  }

  show() {
    this.element.hidden = false;
    this.follow = () => this.place();
    this.viewer.afterDraw.add(this.follow);
    window.addEventListener('pointerdown', () => this.hide(), { once: true, capture: true });
    window.addEventListener('keydown', () => this.hide(), { once: true, capture: true });
    this.place();
  }

  hide() {
    this.element.hidden = true;
    this.viewer.afterDraw.delete(this.follow);
  }

  // beside the first source, on the side where there is more room
  place() {
    const [marker] = this.viewer.sourceMarkers;
    if (!marker || !marker.visible) return;
    const at = this.viewer.pixelAt(marker.position);
    const { width } = this.viewer.size;
    const isLeft = at[0] > width / 2;
    this.element.style.left = isLeft ? '' : `${at[0] + 14}px`;
    this.element.style.right = isLeft ? `${width - at[0] + 14}px` : '';
    this.element.style.top = `${at[1]}px`;
  }
}
