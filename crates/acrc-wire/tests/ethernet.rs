//! Fast status and connection management.

use acrc_wire::ethernet::management::{self, DownloadResult};
use acrc_wire::ethernet::{ControllerAlarm, Crc, FILE_LEN, FastStatus, Subscription, Watchdog, is_intact, seal};
use acrc_wire::{ByteOrder, CrcRule, Field, Item, Malformed, WireOptions};

const OPTIONS: fn() -> WireOptions = WireOptions::default;

fn check_request(request: management::Request<'_>, bytes: &[u8]) {
    let mut sent = Vec::new();
    request.encode(&OPTIONS(), &mut sent);
    assert_eq!(sent, bytes);
    assert_eq!(management::requests(OPTIONS()).next_item(&mut &*sent), Some(Item::Packet(request)));
}

fn check_reply(reply: management::Reply<'_>, bytes: &[u8]) {
    let mut sent = Vec::new();
    reply.encode(&OPTIONS(), &mut sent);
    assert_eq!(sent, bytes);
    assert_eq!(management::replies(OPTIONS()).next_item(&mut &*sent), Some(Item::Packet(reply)));
}

#[test]
fn a_subscription_is_eight_bytes() {
    let every = Subscription::every(10);
    assert_eq!(every.encode(), [0, 0, 0, 1, 0, 0, 0, 10]);
    assert_eq!(Subscription::decode(&every.encode()), Ok(every));
    assert!(Subscription::end().is_end() && !every.is_end());
    let other = Subscription::decode(&[0x80, 0, 0, 0, 0, 0, 0x01, 0x02]).unwrap();
    assert!(!other.is_end(), "every mode but zero subscribes");
    assert_eq!(other.interval_milliseconds, 0x0102);
    assert_eq!(Subscription::decode(&[0; 7]), Err(Malformed::Short));
}

#[test]
fn status_is_eighty_fields() {
    let mut status = FastStatus::default();
    status.0[0][1] = Field::from(-2);
    status.0[9][7] = Field::from(0.5_f32);
    let bytes = status.encode();
    assert_eq!(bytes.len(), 320);
    assert_eq!(bytes[4..8], [0xFF, 0xFF, 0xFF, 0xFE]);
    assert_eq!(bytes[316..], [0x3F, 0x00, 0x00, 0x00]);
    let read = FastStatus::decode(&bytes).unwrap();
    assert_eq!((read.0[0][1].long(), read.0[9][7].single()), (-2, 0.5));
    assert_eq!(read, status);
    assert_eq!(FastStatus::decode(&bytes[1..]), Err(Malformed::Short));
}

#[test]
fn watchdogs_are_echoed() {
    let watchdog = Watchdog {
        timer: 500,
        ticker: 3,
        address: [192, 168, 10, 40].into(),
        command_port: 40000,
        fast_status_port: 50000,
    };
    let bytes =
        [[0, 0, 0, 1], [0, 0, 0x01, 0xF4], [0, 0, 0, 3], [192, 168, 10, 40], [0, 0, 0x9C, 0x40], [0, 0, 0xC3, 0x50]];
    check_request(management::Request::Watchdog(watchdog), bytes.as_flattened());
    check_reply(management::Reply::Watchdog(watchdog), bytes.as_flattened());
}

#[test]
fn alarms_pass_filters() {
    check_request(management::Request::UserAlarms { filter: 5 }, &[0, 0, 0, 2, 0, 0, 0, 5]);
    check_request(management::Request::ControllerAlarms { filter: 6 }, &[0, 0, 0, 3, 0, 0, 0, 6]);
    check_reply(management::Reply::UserAlarm { value: 7 }, &[0, 0, 0, 2, 0, 0, 0, 7]);
    let alarm = ControllerAlarm { code: 8, object: 9, count: 10 };
    check_reply(management::Reply::ControllerAlarm(alarm), &[0, 0, 0, 3, 0, 0, 0, 8, 0, 0, 0, 9, 0, 0, 0, 10]);
    assert!(alarm.passes(0b1100) && !alarm.passes(0b0111) && !alarm.passes(0));
    assert!(management::passes(u32::MAX, 1));
}

#[test]
fn a_download_from_end_to_end() {
    let mut file = [0x5A; FILE_LEN];
    seal(&mut file, CrcRule::Ethernet, ByteOrder::BigEndian);
    check_request(management::Request::ConfigurationFile, &[0, 0, 0, 4]);
    check_reply(management::Reply::ConfigurationFile(&file), &[&[0, 0, 0, 4][..], &file].concat());
    let block = management::Request::Block { index: 1023, data: &file };
    check_request(block, &[&[0, 0, 0, 5, 0, 0, 0x03, 0xFF][..], &file].concat());
    check_request(management::Request::EndDownload, &[0, 0, 0, 6]);
    for (result, value) in
        [(DownloadResult::Success, 0), (DownloadResult::CrcFailure, 1), (DownloadResult::FlashFailure, 2)]
    {
        check_reply(management::Reply::DownloadResult(result), &[0, 0, 0, 6, 0, 0, 0, value]);
    }
    check_request(management::Request::Reboot, &[0, 0, 0, 7]);
}

#[test]
fn what_means_nothing_costs_its_own_bytes_only() {
    let mut bytes = vec![0, 0, 0, 8];
    bytes.extend([0, 0, 0, 5, 0, 0, 0x04, 0x00]);
    bytes.extend([0; FILE_LEN]);
    bytes.extend([0, 0, 0, 7]);
    let mut input = &*bytes;
    let mut decoder = management::requests(OPTIONS());
    assert_eq!(decoder.next_item(&mut input), Some(Item::Unreadable(Malformed::ManagementId(8))));
    assert_eq!(decoder.next_item(&mut input), Some(Item::Unreadable(Malformed::BlockIndex(1024))));
    assert_eq!(decoder.next_item(&mut input), Some(Item::Packet(management::Request::Reboot)));

    let mut replies = management::replies(OPTIONS());
    let result = [0, 0, 0, 6, 0, 0, 0, 3];
    assert_eq!(replies.next_item(&mut &result[..]), Some(Item::Unreadable(Malformed::DownloadResult(3))));
    let request = [0, 0, 0, 5];
    let unreadable = Some(Item::Unreadable(Malformed::ManagementId(5)));
    assert_eq!(replies.next_item(&mut &request[..]), unreadable, "the controller sends no blocks");
}

#[test]
fn the_crc_is_that_of_ethernet() {
    let check = |rule| {
        let mut crc = Crc::new(rule);
        crc.update(b"1234");
        crc.update(b"56789");
        crc.value()
    };
    // The check values of CRC-32/ISO-HDLC and CRC-32/MPEG-2.
    assert_eq!(check(CrcRule::Ethernet), 0xCBF4_3926);
    assert_eq!(check(CrcRule::HighBitFirst), 0x0376_E6E7);
    let bytes: Vec<_> = (0..=u8::MAX).collect();
    let mut crc = Crc::new(CrcRule::Ethernet);
    crc.update(&bytes);
    assert_eq!(crc.value(), crc32fast::hash(&bytes));
}

#[test]
fn a_changed_file_is_noticed() {
    for rule in [CrcRule::Ethernet, CrcRule::HighBitFirst] {
        for order in [ByteOrder::BigEndian, ByteOrder::LittleEndian] {
            let mut file = [7; FILE_LEN];
            seal(&mut file, rule, order);
            assert!(is_intact(&file, rule, order));
            file[512] ^= 0x10;
            assert!(!is_intact(&file, rule, order));
        }
    }
    assert!(!is_intact(&[1, 2, 3], CrcRule::Ethernet, ByteOrder::BigEndian));
    let mut short = [1, 2, 3];
    seal(&mut short, CrcRule::Ethernet, ByteOrder::BigEndian);
    assert_eq!(short, [1, 2, 3]);
}
