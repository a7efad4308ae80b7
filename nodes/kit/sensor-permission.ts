/** The answer to the request for motion sensors. `absent`: the browser gives pages no sensors. */
export type SensorAnswer = 'granted' | 'denied' | 'absent';

/** The class of a sensor event. In Safari on iOS it has a function that asks the visitor for permission. */
type SensorEvents = { readonly requestPermission?: () => Promise<string> } | undefined;

const GESTURES = ['pointerup', 'keyup'] as const;

/**
 * Calls `act` at the visitor's touches and key presses, because browsers let pages ask for permissions only then.
 *
 * @returns A function that stops listening.
 *
 * @example
 * const stop = onGestures(ask);
 */
export function onGestures(act: () => void): () => void {
  for (const gesture of GESTURES) document.addEventListener(gesture, act);
  return () => {
    for (const gesture of GESTURES) document.removeEventListener(gesture, act);
  };
}

/**
 * Asks for the sensors of motion and orientation, at the visitor's first touch where the browser shows a question, else at once. One
 * permission covers both.
 *
 * @param onAnswer Called once, but not after the request was ended.
 * @returns A function that ends the request.
 *
 * @example
 * const stop = askForSensors((answer) => { if (answer === 'granted') listen(); });
 */
export function askForSensors(onAnswer: (answer: SensorAnswer) => void): () => void {
  const page = window as { readonly DeviceMotionEvent?: SensorEvents; readonly DeviceOrientationEvent?: SensorEvents };
  const events = [page.DeviceMotionEvent, page.DeviceOrientationEvent];
  if (events.every((each) => each === undefined)) {
    onAnswer('absent');
    return () => {};
  }
  const asking = events.filter((each) => typeof each?.requestPermission === 'function');
  if (asking.length === 0) {
    onAnswer('granted');
    return () => {};
  }
  let isOver = false;
  let isAsking = false;
  const stop = onGestures(() => {
    if (isAsking || isOver) return;
    isAsking = true;
    // It rejects where the touch does not count as one; the next may.
    Promise.all(asking.map((each) => each?.requestPermission?.())).then(
      (answers) => {
        stop();
        if (!isOver) onAnswer(answers.every((answer) => answer === 'granted') ? 'granted' : 'denied');
      },
      () => {
        isAsking = false;
      },
    );
  });
  return () => {
    isOver = true;
    stop();
  };
}
