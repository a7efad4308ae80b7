/** What hosts tell of an image beside its pixels, by the names that they give to uniforms: `_inputImage_imgSize`. */
const PROPERTY = /^_(\w+)_(imgRect|imgSize|flip)$/;

export interface ImageProperty {
  readonly image: string;
  /** `imgRect`: origin and size of the part that is used, from 0 to 1: all of it. `flip`: whether it stands on its head: never. */
  readonly property: 'imgRect' | 'imgSize' | 'flip';
}

export const IMAGE_PROPERTY_TYPES = { imgRect: 'vec4', imgSize: 'vec2', flip: 'bool' } as const;

export function imageProperty(name: string): ImageProperty | null {
  const [, image, property] = PROPERTY.exec(name) ?? [];
  return image === undefined ? null : { image, property: property as ImageProperty['property'] };
}
