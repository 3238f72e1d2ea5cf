//! Finds the displacements of a perfect hash (hash and displace).

use super::line;
use crate::hash::{PerfectHash, hash, slot};

/// Emits the hash of these keys; an entry of the hash is the position of its key.
pub fn emit(out: &mut String, name: &str, keys: &[(u16, String)]) {
    let bits = (keys.len() * 5 / 4).next_power_of_two().trailing_zeros();
    let buckets = keys.len().div_ceil(3).max(1);
    let (displacements, slots) = displace(keys, buckets, bits);
    line(
        out,
        format_args!(
            "pub(crate) static {name}: PerfectHash<'static> = PerfectHash {{ displacements: &{displacements:?}, slots: &{slots:?}, bits: {bits} }};"
        ),
    );
}

/// Places the fullest buckets first, each under the first displacement that meets no taken slot.
fn displace(keys: &[(u16, String)], buckets: usize, bits: u32) -> (Vec<u16>, Vec<u16>) {
    let mut members = vec![Vec::new(); buckets];
    for (index, (salt, word)) in keys.iter().enumerate() {
        let hash = hash(*salt, word.as_bytes());
        members[(hash % buckets as u64) as usize].push((index, hash));
    }
    let mut order: Vec<usize> = (0..buckets).collect();
    order.sort_by_key(|bucket| std::cmp::Reverse(members[*bucket].len()));
    let mut displacements = vec![0; buckets];
    let mut slots = vec![PerfectHash::EMPTY; 1 << bits];
    for bucket in order {
        let free = (0..u16::MAX).find(|displacement| fits(&members[bucket], *displacement, bits, &slots));
        let displacement = free.expect("a table with a fifth of its slots free can be displaced");
        displacements[bucket] = displacement;
        for (index, hash) in &members[bucket] {
            slots[slot(*hash, displacement, bits)] = *index as u16;
        }
    }
    (displacements, slots)
}

fn fits(members: &[(usize, u64)], displacement: u16, bits: u32, slots: &[u16]) -> bool {
    let mut wanted: Vec<usize> = members.iter().map(|(_, hash)| slot(*hash, displacement, bits)).collect();
    wanted.sort_unstable();
    wanted.windows(2).all(|pair| pair[0] != pair[1]) && wanted.iter().all(|slot| slots[*slot] == PerfectHash::EMPTY)
}
