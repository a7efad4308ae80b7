/** Single steps of paused time. Each waits until the previous frame is drawn, so that stateful nodes see every frame. */
export interface Steps {
  /** Steps at once or, if the current frame is not drawn yet, after it. */
  ask(): void;
  /** Called after a frame is drawn. `late`: an earlier frame was drawn because the current one is still being decoded. */
  afterFrame(late: boolean): void;
  /** Called when time goes elsewhere or continues: steps that wait are dropped. */
  restart(): void;
}

export function createSteps(step: () => void): Steps {
  let drawn = false;
  let waiting = 0;
  const go = () => {
    drawn = false;
    step();
  };
  return {
    ask: () => {
      if (drawn) go();
      else waiting++;
    },
    afterFrame: (late) => {
      drawn = !late;
      if (!drawn || waiting === 0) return;
      waiting--;
      go();
    },
    restart: () => {
      drawn = false;
      waiting = 0;
    },
  };
}
