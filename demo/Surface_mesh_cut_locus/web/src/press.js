// Whether a press is a click: that of one pointer, which is let go at about the same place. A second finger makes it none, as
// it begins to zoom.

const clickPixels = { mouse: 4, pen: 6, touch: 10 }; // a click moves no more

export class Press {
  constructor() {
    this.cancel();
  }

  cancel() {
    this.pointer = null;
    this.isMoving = false;
  }

  down({ pointerId, pointerType, isPrimary, button, clientX, clientY }) {
    this.cancel();
    if (!isPrimary || button !== 0) return;
    this.pointer = pointerId;
    this.start = [clientX, clientY];
    this.reach = clickPixels[pointerType] ?? clickPixels.mouse;
  }

  // Whether it has become one that moves. One that comes back is no click either.
  move({ pointerId, clientX, clientY }) {
    if (pointerId !== this.pointer) return false;
    this.isMoving ||= Math.hypot(clientX - this.start[0], clientY - this.start[1]) > this.reach;
    return this.isMoving;
  }

  // Whether it has been a click.
  up(event) {
    if (this.pointer === null || event.pointerId !== this.pointer) return false;
    const isClick = !this.move(event);
    this.cancel();
    return isClick;
  }
}
