/**
 * The interface of techniques, as GLSL that the checker reads before the author's text. In the printed text every name has the prefix `a_`,
 * and the renderer defines it (`export/runtime/scenes/materials/technique-wrapper.ts`).
 *
 * Positions are in meters, directions have unit length, both in world space; colors are linear-sRGB with straight alpha. `rest` is the
 * position in local space, in meters, before skinning. `outward` is the hull normal, for outlines: moving each vertex by it moves all
 * adjacent faces by one, so that no gaps open at hard edges. Passes of edges set `contour`, `crease`, `roomM` and `line`, and read `widthPx` and
 * `endPx`; `outward` points away from the object there. `along`, `smoothNormal` and `radial` are computed for a mesh if the text names them.
 * `AMBIENT` is `IRRADIANCE` of the surface's own normal, divided by π. `BEHIND` is what is behind the object at a view UV, as seen through glass of the roughness: premultiplied, with the coverage as alpha.
 */
export const TECHNIQUE_INTERFACE = `struct Vertex { vec3 position; vec3 normal; vec2 uv; vec4 color; vec3 rest; vec3 outward; bool contour; float crease; float widthPx; float endPx; float roomM; };
struct Surface { vec3 position; vec3 normal; vec3 towardsEye; vec2 uv; vec4 color; bool front; vec3 rest; vec3 restNormal; vec3 line; vec3 along; vec3 smoothNormal; vec2 radial; };
struct Light { vec3 towards; vec3 radiance; float lit; };
vec3 EYE;
vec3 AMBIENT;
int LIGHT_COUNT;
int PASSINDEX;
float TIME;
vec2 RENDERSIZE;
Light LIGHT(const in int index);
vec3 IRRADIANCE(const in vec3 normal);
vec3 REFLECTION(const in vec3 direction, const in float roughness);
Light ENVIRONMENT();
vec2 VIEW_UV(const in vec3 position);
float VIEW_DEPTH(const in vec3 position);
float PIXEL_M(const in vec3 position);
vec4 BEHIND(const in vec2 uv, const in float roughness);
`;

/**
 * The structs and functions of the interface, as the printed text of both stages declares them. Only the surface may call the functions of
 * light. Where the author discards, the text sets `scrim_discarded` and returns.
 */
export const PRINTED_STRUCTS = `struct a_Vertex { vec3 position; vec3 normal; vec2 uv; vec4 color; vec3 rest; vec3 outward; bool contour; float crease; float widthPx; float endPx; float roomM; };
struct a_Surface { vec3 position; vec3 normal; vec3 towardsEye; vec2 uv; vec4 color; bool front; vec3 rest; vec3 restNormal; vec3 line; vec3 along; vec3 smoothNormal; vec2 radial; };
struct a_Light { vec3 towards; vec3 radiance; float lit; };
a_Light a_LIGHT(const in int index);
vec3 a_IRRADIANCE(const in vec3 normal);
vec3 a_REFLECTION(const in vec3 direction, const in float roughness);
a_Light a_ENVIRONMENT();
vec2 a_VIEW_UV(const in vec3 position);
float a_VIEW_DEPTH(const in vec3 position);
float a_PIXEL_M(const in vec3 position);
bool scrim_discarded = false;`;

/** Declaration of `BEHIND`. It is printed only in texts that call it, because materials that declare it are drawn after all others. */
export const PRINTED_BEHIND = 'vec4 a_BEHIND(const in vec2 uv, const in float roughness);';

export const INTERFACE_LINES = TECHNIQUE_INTERFACE.split('\n').length - 1;

/** Functions that only `surface` may call. */
export const LIGHT_FUNCTIONS: ReadonlySet<string> = new Set(['LIGHT', 'IRRADIANCE', 'REFLECTION', 'ENVIRONMENT', 'BEHIND']);
