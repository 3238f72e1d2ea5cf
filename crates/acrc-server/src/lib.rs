//! A virtual controller on the network: the four ports of an ACR controller over a controller in virtual time.
