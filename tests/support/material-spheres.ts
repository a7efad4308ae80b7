import { SphereGeometry } from 'three';

/**
 * Material extensions of glTF with visible values, by name. Those of glass are in the real models `AttenuationTest`, `GlassTable` and
 * `TransmissionRoughnessTest`.
 */
export const MATERIAL_EXTENSIONS: Readonly<Record<string, object>> = {
  KHR_materials_anisotropy: { anisotropyStrength: 0.9, anisotropyRotation: 0.7 },
  KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatRoughnessFactor: 0.1 },
  KHR_materials_diffuse_roughness: { diffuseRoughnessFactor: 1 },
  KHR_materials_emissive_strength: { emissiveStrength: 4 },
  KHR_materials_ior: { ior: 2.2 },
  KHR_materials_iridescence: { iridescenceFactor: 1, iridescenceIor: 1.8 },
  KHR_materials_sheen: { sheenColorFactor: [0.9, 0.2, 0.5], sheenRoughnessFactor: 0.4 },
  KHR_materials_specular: { specularFactor: 1, specularColorFactor: [1, 0.3, 0.1] },
  KHR_materials_unlit: {},
};

/** A .gltf with one sphere per extension in a row, and a plain one at the end; 2.2 m between centers. */
export function materialSpheres(): string {
  const { attributes, index } = new SphereGeometry(1, 32, 24);
  const arrays = [attributes.position?.array, attributes.normal?.array, index?.array].map((array) => {
    const bytes = array && new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    if (!bytes) throw new Error('The ball has no geometry.');
    return bytes;
  });
  const count = attributes.position?.count ?? 0;
  const offsets = arrays.map((_, i) => arrays.slice(0, i).reduce((sum, { byteLength }) => sum + byteLength, 0));
  const all = [...Object.keys(MATERIAL_EXTENSIONS), null];
  const byteLength = arrays.reduce((sum, array) => sum + array.byteLength, 0);
  return JSON.stringify({
    asset: { version: '2.0' },
    extensionsUsed: Object.keys(MATERIAL_EXTENSIONS),
    scene: 0,
    scenes: [{ nodes: all.map((_, i) => i) }],
    nodes: all.map((_, i) => ({ mesh: i, translation: [2.2 * i, 0, 0] })),
    meshes: all.map((_, i) => ({ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: i }] })),
    materials: all.map((name) => ({
      pbrMetallicRoughness: { baseColorFactor: [0.2, 0.35, 0.6, 1], roughnessFactor: 0.35, metallicFactor: 0 },
      ...(name === 'KHR_materials_emissive_strength' && { emissiveFactor: [0.2, 0.1, 0] }),
      ...(name !== null && { extensions: { [name]: MATERIAL_EXTENSIONS[name] } }),
    })),
    accessors: [
      { bufferView: 0, componentType: 5126, count, type: 'VEC3', min: [-1, -1, -1], max: [1, 1, 1] },
      { bufferView: 1, componentType: 5126, count, type: 'VEC3' },
      { bufferView: 2, componentType: 5123, count: index?.count, type: 'SCALAR' },
    ],
    bufferViews: arrays.map((array, i) => ({ buffer: 0, byteOffset: offsets[i], byteLength: array.byteLength })),
    buffers: [{ byteLength, uri: `data:application/octet-stream;base64,${Buffer.concat(arrays).toString('base64')}` }],
  });
}
