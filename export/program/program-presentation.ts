/** Fixed before a session starts, because WebXR framebuffers cannot change afterwards. */
export interface Presentation {
  /** `forward`: draws directly to the session's framebuffer. `composed`: at least one layer is needed as an image. */
  readonly mode: 'forward' | 'composed';
  readonly antialias: boolean;
  /** `world`: passthrough or the session's camera image. A color is display-referred sRGB, straight alpha. */
  readonly background: 'world' | readonly [number, number, number, number];
  readonly blend: 'alpha';
  /**
   * The depth buffer of the session's framebuffer. `none`: nothing needs one. `whole`: it shows all that is drawn, so that a headset may
   * shift the image by it. Absent: it is needed, but shows only a part.
   */
  readonly screenDepth?: 'none' | 'whole';
  /**
   * Present if the screen shows an image without transparency in each of its pixels, or a color of its own, so that no room is visible.
   * `if-files-do`: if the image and video files have no transparency.
   */
  readonly covers?: true | 'if-files-do';
  /** Start of the orbit camera if it is not the default: its target in world space and its distance, meters. */
  readonly around?: { readonly targetWorld: readonly [number, number, number]; readonly distanceM: number };
}
