//! Elementary functions on lanes, by our own polynomials: the platform's differ from machine to machine.
