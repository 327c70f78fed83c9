// What can be taken back: sources, method and thresholds, as they were one after the other.

const longest = 100;

export class History {
  constructor() {
    this.clear();
  }

  clear() {
    this.steps = [];
    this.at = -1;
  }

  // Remembers a state, unless it is that of the last step. What had been taken back is forgotten;
  // so is the last step, if this one `replacesLast`.
  push(state, replacesLast = false) {
    const text = JSON.stringify(state);
    if (this.steps[this.at] === text) return;
    this.steps.length = this.at + (replacesLast ? 0 : 1);
    this.steps.push(text);
    if (this.steps.length > longest) this.steps.shift();
    this.at = this.steps.length - 1;
  }

  get canUndo() {
    return this.at > 0;
  }

  get canRedo() {
    return this.at < this.steps.length - 1;
  }

  undo() {
    return this.canUndo ? JSON.parse(this.steps[--this.at]) : null;
  }

  redo() {
    return this.canRedo ? JSON.parse(this.steps[++this.at]) : null;
  }
}
