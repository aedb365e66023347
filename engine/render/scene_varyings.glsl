// The block between vertex and fragment stage; SCENE_VARYING is `out` or `in`. The material's factors travel along
// unchanged: once a vertex they are cheap to fetch, once a fragment they are not.
SCENE_VARYING SceneVaryings {
    vec3 position;  // render space
    vec3 normal;    // render space, unit at vertices
    vec4 tangent;   // render space, w = +-1
    vec4 uv;        // sets 0 and 1
    vec4 colour;    // vertex colour times base colour factor (KEEPS_ALBEDO: see kNumberedMaterials)
    flat vec4 lobes;  // metallic, roughness, transmission, dielectric F0 without its specular factors
    flat vec3 kept;   // KEEPS_ALBEDO: share of the base colour that even light is reflected by, what is reflected whatever
                      // its colour, and the material's number in the map (0: none); without textures' part
    flat uint flags;  // MaterialData::flags
    flat uint material;
    flat uint instance;
} scene;
