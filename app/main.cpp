#include "config/reader/scene.h"
int main() { return 1; }
