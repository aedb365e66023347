// The block between vertex and fragment stage; SCENE_VARYING is `out` or `in`.
SCENE_VARYING SceneVaryings {
    vec3 position;  // render space
    vec3 normal;    // render space, unit at vertices
    vec4 tangent;   // render space, w = +-1
    vec4 uv;        // sets 0 and 1
    vec4 colour;
    flat uint material;
    flat uint instance;
} scene;
