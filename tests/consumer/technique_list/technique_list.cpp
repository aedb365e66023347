// Ends with 0 if the techniques that this program links are known to it without a call.
#include "lanthorn/gi/technique.h"

int main() {
    return lanthorn::gi::find_technique("emc") != nullptr ? 0 : 1;
}
