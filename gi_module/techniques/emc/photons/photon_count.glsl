// How many photons a PhotonSet holds (photon_set.h). PHOTON_COUNT_BINDING: of its storage buffer.
layout(std430, binding = PHOTON_COUNT_BINDING) readonly buffer PhotonCount { uint photon_set_count; };
