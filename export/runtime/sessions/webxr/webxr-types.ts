/** Types of WebXR that @types/webxr does not have yet. */

/** The size of a camera image (WebXR Raw Camera Access §4). */
export interface XrCamera {
  readonly width: number;
  readonly height: number;
}

export interface XrViewWithCamera extends XRView {
  readonly camera?: XrCamera | null;
}

/** The members of `XRWebGLBinding` that WebXR Raw Camera Access §4 and Depth Sensing §3.3 define. */
export interface XrBinding {
  getCameraImage?(camera: XrCamera): WebGLTexture | null;
  /** Returns the reflection cube map of a light probe (WebXR Lighting Estimation §5.1). The browser owns the texture. */
  getReflectionCubeMap?(probe: XrLightProbe): WebGLTexture | null;
  getDepthInformation?(view: XRView): XrGpuDepthInformation | null | undefined;
}

export interface XrGpuDepthInformation extends Omit<XRWebGLDepthInformation, 'textureType' | 'imageIndex'> {
  /** The kind of the texture and its layer; not every browser reports `textureType` and `imageIndex`. */
  readonly textureType?: XRTextureType;
  readonly imageIndex?: number | null;
  /**
   * Quest Browser and iwer have these non-standard attributes: the texture then contains window-space depth between them, its first row at
   * the bottom.
   */
  readonly depthNear?: number;
  readonly depthFar?: number;
  /** Quest Browser: false while the texture has no valid content. */
  readonly isValid?: boolean;
}

/** A light probe of the browser (WebXR Lighting Estimation §3). */
export interface XrLightProbe extends EventTarget {
  readonly probeSpace: XRSpace;
}

export interface XrLightEstimate {
  readonly sphericalHarmonicsCoefficients: Float32Array;
  readonly primaryLightDirection: DOMPointReadOnly;
  readonly primaryLightIntensity: DOMPointReadOnly;
}

export interface XrSessionWithLight extends XRSession {
  readonly preferredReflectionFormat?: 'srgba8' | 'rgba16f';
  requestLightProbe?(options?: { readonly reflectionFormat?: 'srgba8' | 'rgba16f' }): Promise<XrLightProbe>;
}

export interface XrFrameWithLight extends XRFrame {
  getLightEstimate?(probe: XrLightProbe): XrLightEstimate | null;
}

/** A plane that the browser detects (WebXR Plane Detection §2.1). */
export interface XrPlane {
  readonly planeSpace: XRSpace;
  readonly polygon: readonly DOMPointReadOnly[];
  /** Orientation of the plane; absent or null if the plane is neither horizontal nor vertical. */
  readonly orientation?: 'horizontal' | 'vertical' | null;
  readonly semanticLabel?: string;
  readonly lastChangedTime: number;
}

/** A mesh that the browser detects (WebXR Mesh Detection §2.1). */
export interface XrMesh {
  readonly meshSpace: XRSpace;
  readonly vertices: Float32Array;
  readonly indices: Uint32Array;
  readonly semanticLabel?: string;
  readonly lastChangedTime: number;
}

/** The members of `XRFrame` that give the poses and radii of many joints at once (WebXR Hand Input §4). */
export interface XrFrameWithJoints extends XRFrame {
  /** Writes the matrix of each space. Returns false, and may leave `transforms` unchanged, if a space has no pose. */
  fillPoses?(spaces: readonly XRSpace[], baseSpace: XRSpace, transforms: Float32Array): boolean;
  /** Writes the radius of each joint; NaN for a joint without a radius. */
  fillJointRadii?(jointSpaces: readonly XRJointSpace[], radii: Float32Array): boolean;
}
