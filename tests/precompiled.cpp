// A library needs a source: this one carries the precompiled header of the tests.
