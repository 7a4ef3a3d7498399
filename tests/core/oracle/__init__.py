"""Independent judges of the engine: what the thesis and the behaviour contract say, written without the engine."""
