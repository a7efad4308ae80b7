/**
 * What a technique is written against, as GLSL that the checker reads before the author's text. In the printed text every name
 * in it has the prefix `a_`, and the one who draws defines it (`export/runtime/scenes/materials/technique-wrapper.ts`).
 *
 * Positions are in metres and directions of unit length, in world space; colours are linear-sRGB with straight alpha.
 */
export const TECHNIQUE_INTERFACE = `struct Vertex { vec3 position; vec3 normal; vec2 uv; vec4 color; };
struct Surface { vec3 position; vec3 normal; vec3 towardsEye; vec2 uv; vec4 color; bool front; };
struct Light { vec3 towards; vec3 radiance; float lit; };
vec3 EYE;
vec3 AMBIENT;
int LIGHT_COUNT;
int PASSINDEX;
Light LIGHT(const in int index);
`;

/**
 * The structs and what gives a light, as both stages declare them; `LIGHT` is for the surface alone. Where the author discards, the
 * text sets `scrim_discarded` and returns.
 */
export const PRINTED_STRUCTS = `struct a_Vertex { vec3 position; vec3 normal; vec2 uv; vec4 color; };
struct a_Surface { vec3 position; vec3 normal; vec3 towardsEye; vec2 uv; vec4 color; bool front; };
struct a_Light { vec3 towards; vec3 radiance; float lit; };
a_Light a_LIGHT(const in int index);
bool scrim_discarded = false;`;

export const INTERFACE_LINES = TECHNIQUE_INTERFACE.split('\n').length - 1;

/** What gives a light. */
export const INTERFACE_FUNCTION = 'LIGHT';
