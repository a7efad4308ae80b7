import { type EmulatedSensors, installSensors, type SensorOptions } from '../../export/emulator/sensors/emulated-sensors.ts';

/** A page in Node with the sensors of a phone. */
export interface FakeSensors {
  readonly sensors: EmulatedSensors;
  /** The visitor touches the page; resolves when the page has heard what that leads to. */
  touch(): Promise<void>;
  /** Rotates the page on the device. */
  turnPage(angleDeg: number): void;
  /** Listeners of the page and of its document. */
  listening(): number;
  restore(): void;
}

/** Counts its listeners. */
class Target extends EventTarget {
  readonly listeners = new Set<unknown>();
  override addEventListener(...args: Parameters<EventTarget['addEventListener']>): void {
    this.listeners.add(args[1]);
    super.addEventListener(...args);
  }
  override removeEventListener(...args: Parameters<EventTarget['removeEventListener']>): void {
    this.listeners.delete(args[1]);
    super.removeEventListener(...args);
  }
}

const NAMES = ['window', 'document', 'navigator'] as const;

/** @param lacks Interfaces that the browser does not have. */
export function fakeSensors(options: SensorOptions = {}, lacks: readonly string[] = []): FakeSensors {
  const before = NAMES.map((name) => [name, Object.getOwnPropertyDescriptor(globalThis, name)] as const);
  const screen = { orientation: { angle: 0 } };
  const page = Object.assign(new Target(), { screen, DeviceMotionEvent: class {}, DeviceOrientationEvent: class {} });
  for (const name of lacks) Reflect.deleteProperty(page, name);
  const document = new Target();
  const globals = { window: page, document, navigator: {} };
  for (const name of NAMES) Object.defineProperty(globalThis, name, { configurable: true, value: globals[name] });
  const sensors = installSensors(options);
  let isRestored = false;
  return {
    sensors,
    touch: async () => {
      document.dispatchEvent(new Event('pointerup'));
      await new Promise((resolve) => setImmediate(resolve));
    },
    turnPage: (angleDeg) => {
      screen.orientation.angle = angleDeg;
    },
    listening: () => page.listeners.size + document.listeners.size,
    restore: () => {
      if (isRestored) return;
      isRestored = true;
      sensors.uninstall();
      for (const [name, descriptor] of before) {
        if (descriptor) Object.defineProperty(globalThis, name, descriptor);
        else Reflect.deleteProperty(globalThis, name);
      }
    },
  };
}
