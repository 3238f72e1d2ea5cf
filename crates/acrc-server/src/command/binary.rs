//! Packets of the binary host interface, executed by the controller between two ticks.

use acrc_controller::Override;
use acrc_wire::binary::{DataReply, DataRequest, FlagChange, OverrideKind};
use acrc_wire::{Channel, Field, Reply, Request, WireOptions};
use bytes::BytesMut;

use crate::core::Core;

/// Fields of a data packet, at most.
const FIELDS: usize = 8;

/// Executes a request, and puts the answer behind what is to be sent if it has one. A request that is refused is not answered, as the
/// packets have no form for that; one that reads gets zeros for what does not exist, so that its client is not left waiting.
pub(super) fn execute(core: &mut Core, request: &Request<'_>, wire: &WireOptions, out: &mut BytesMut) {
    let mut answer = |reply: Reply<'_>| Channel::ethernet().reply(&reply, out);
    let Core { controller, observer, .. } = core;
    let observer = &mut **observer;
    let refused = match *request {
        Request::GetLong { parameter } => {
            let value = controller.parameter_long(u32::from(parameter)).unwrap_or_default();
            answer(Reply::Long { parameter, value });
            None
        }
        Request::GetSingle { parameter } => {
            let value = controller.parameter_single(u32::from(parameter)).unwrap_or_default();
            answer(Reply::Single { parameter, value });
            None
        }
        Request::Data(data) => {
            let mut fields = [Field::default(); FIELDS];
            if let Some(reply) = data_reply(controller, data, &mut fields) {
                answer(Reply::Data(reply));
            }
            None
        }
        Request::SetLong { parameter, value } => {
            controller.set_parameter_long(u32::from(parameter), value, observer).err()
        }
        Request::SetSingle { parameter, value } => {
            controller.set_parameter_single(u32::from(parameter), value, observer).err()
        }
        Request::ParameterMask { parameter, mask } => {
            controller.mask_parameter(u32::from(parameter), mask.clear, mask.set, observer).err()
        }
        Request::Flag(FlagChange { flag, set }) => controller.set_flag(u32::from(flag), set, observer).err(),
        Request::Override(change) => {
            let kind = match change.kind {
                OverrideKind::Feedrate => Override::Feedrate,
                OverrideKind::Rapid => Override::Rapid,
            };
            controller.set_override(kind, change.masters(wire), change.value, observer).err()
        }
        _ => None,
    };
    drop(refused);
}

fn data_reply<'f>(
    controller: &acrc_controller::Controller,
    request: DataRequest,
    fields: &'f mut [Field; FIELDS],
) -> Option<DataReply<'f>> {
    for (field, parameter) in fields.iter_mut().zip(request.parameters()) {
        let value = parameter.and_then(|parameter| controller.parameter_field(u32::from(parameter)));
        *field = Field(value.unwrap_or_default());
    }
    DataReply::new(request, fields.get(..request.count())?)
}
