//! The texts of `IP`: what a controller says of its place in the network. A virtual controller keeps them; nothing depends on them.

use acrc_catalog::Model;

/// Address, mask and gateway.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Network {
    pub(crate) address: String,
    pub(crate) mask: String,
    pub(crate) gateway: String,
}

/// Models whose clients expect another factory address than that of the guide.
const ON_SUBNET_100: [&str; 2] = ["ACR7000", "IPA"];

impl Network {
    /// With factory settings (guide, "Ethernet"; field code for the later models).
    pub(crate) fn of(model: &Model) -> Self {
        let address = if ON_SUBNET_100.contains(&model.name) { "192.168.100.1" } else { "192.168.10.40" };
        Self { address: address.to_owned(), mask: "255.255.255.0".to_owned(), gateway: "0.0.0.0".to_owned() }
    }
}
