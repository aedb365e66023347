// Ways of splatting that give the same picture: which is faster depends on the device.
#pragma once

namespace lanthorn::gi {

// How photons find the tiles of the screen that they touch. The lists are the same, bit for bit.
enum class SplatBinning {
    by_tile,   // each tile tries every photon
    by_photon  // each photon tries the tiles that the picture of its sphere touches
};

// How pixels sum splats. The sums are the same but for the order that they are added in.
enum class SplatKernel {
    batches,  // few invocations share a tile's photons out, each for the same eight pixels
    pixels    // an invocation a pixel; 64 of them share photons
};

}  // namespace lanthorn::gi
