//! What one end encodes, the other end decodes: every packet, on every channel.

mod support;

use acrc_wire::binary::{
    Address, BitMask, Conversion, DataReply, DataRequest, FlagChange, Override, OverrideKind, Peek, PeekReply, Poke,
    VariableKind,
};
use acrc_wire::{Field, Reply, Request};
use proptest::prelude::*;
use support::{Seen, channels, see_whole};

/// Values that have no influence on one another.
#[derive(Clone, Debug)]
struct Values {
    word: u16,
    longs: [u32; 3],
    bytes: [u8; 3],
    fields: Vec<Field>,
    choice: usize,
}

fn values() -> impl Strategy<Value = Values> {
    let fields = prop::collection::vec(any::<u32>().prop_map(Field), 255);
    let parts = (any::<u16>(), any::<[u32; 3]>(), any::<[u8; 3]>(), fields, any::<usize>());
    parts.prop_map(|(word, longs, bytes, fields, choice)| Values { word, longs, bytes, fields, choice })
}

impl Values {
    fn conversion(&self) -> Conversion {
        [Conversion::Long, Conversion::Double, Conversion::Single][self.choice % 3]
    }

    fn data(&self) -> DataRequest {
        let [group, index, mask] = self.bytes;
        // Group 0 with nothing else is what channels are filled up with; identifiers are no groups.
        let group = if (0x88..=0x95).contains(&group) { 0x30 } else { group.max(1) };
        DataRequest { group, index, mask }
    }

    fn peek(&self) -> Peek {
        Peek { conversion: self.conversion(), count: self.bytes[0], address: self.longs[0] }
    }

    fn address(&self) -> Address {
        Address { program: self.bytes[0], kind: VariableKind::ALL[self.choice % 8] }
    }

    fn requests(&self) -> Vec<Request<'_>> {
        let parameter = self.word;
        let mask = BitMask { clear: self.longs[0], set: self.longs[1] };
        let [long, ..] = self.longs.map(Field);
        let fields = &self.fields[..usize::from(self.bytes[0])];
        let kind = [OverrideKind::Feedrate, OverrideKind::Rapid][self.choice % 2];
        vec![
            Request::Data(self.data()),
            Request::GetLong { parameter },
            Request::SetLong { parameter, value: long.long() },
            Request::GetSingle { parameter },
            Request::SetSingle { parameter, value: long.single() },
            Request::Peek(self.peek()),
            Request::Poke(Poke::new(self.conversion(), self.longs[0], fields).unwrap()),
            Request::Address(self.address()),
            Request::ParameterAddress { parameter },
            Request::Mask { address: self.longs[2], mask },
            Request::ParameterMask { parameter, mask },
            Request::Override(Override { kind, masks: self.bytes, value: long.single() }),
            Request::Flag(FlagChange { flag: self.word, set: self.choice.is_multiple_of(2) }),
        ]
    }

    fn replies(&self) -> Vec<Reply<'_>> {
        let parameter = self.word;
        let [value, ..] = self.longs.map(Field);
        let address = self.longs[0];
        let data = DataReply::new(self.data(), &self.fields[..self.data().count()]).unwrap();
        let peek = PeekReply::new(self.peek(), &self.fields[..usize::from(self.peek().count)]).unwrap();
        vec![
            Reply::Data(data),
            Reply::Long { parameter, value: value.long() },
            Reply::Single { parameter, value: value.single() },
            Reply::Peek(peek),
            Reply::Address { request: self.address(), address },
            Reply::ParameterAddress { parameter, address },
        ]
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 100, ..ProptestConfig::default() })]

    #[test]
    fn requests_come_back(values in values()) {
        for channel in channels() {
            let mut bytes = Vec::new();
            let mut expected = Vec::new();
            for request in values.requests() {
                channel.text(b"P\r", &mut bytes);
                channel.request(&request, &mut bytes);
                expected.extend([Seen::Text(b"P\r".to_vec()), Seen::Packet(format!("{request:?}"))]);
            }
            prop_assert_eq!(see_whole(channel.requests(), &bytes), expected);
        }
    }

    #[test]
    fn replies_come_back(values in values()) {
        for channel in channels() {
            let mut bytes = Vec::new();
            let mut expected = Vec::new();
            for reply in values.replies() {
                bytes.extend(b"P00>");
                channel.reply(&reply, &mut bytes);
                expected.extend([Seen::Text(b"P00>".to_vec()), Seen::Packet(format!("{reply:?}"))]);
            }
            prop_assert_eq!(see_whole(channel.replies(), &bytes), expected);
        }
    }

    #[test]
    fn a_question_and_its_answer_begin_alike(values in values()) {
        let channel = acrc_wire::Channel::ethernet();
        let asked = values.requests().into_iter().filter(Request::is_answered).collect::<Vec<_>>();
        // In the order of the answers.
        let [data, long, single, peek, address, parameter] = asked[..] else { panic!("{asked:?}") };
        for (request, reply) in [data, long, single, peek, address, parameter].into_iter().zip(values.replies()) {
            let (mut question, mut answer) = (Vec::new(), Vec::new());
            channel.request(&request, &mut question);
            channel.reply(&reply, &mut answer);
            prop_assert_eq!(&question[..4], &answer[..4]);
        }
    }
}
