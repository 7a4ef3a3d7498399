"""One decision: the engine, the steps of the thesis, and the behaviour contract round them."""
