//! Bathroom furniture and fixtures.

mod fixture;
mod hung;
mod storage;
mod tap;

use super::{Generator, cooker, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("bathroom_cabinet", 9, storage::bathroom_cabinet),
    indoor("bathroom_vanity", 10, storage::bathroom_vanity),
    indoor("bathroom_shelf", 9, storage::bathroom_shelf),
    indoor("bathroom_counter", 4, cooker::bathroom_counter),
    indoor("medicine_cabinet", 8, storage::medicine_cabinet),
    indoor("towel_cabinet", 7, storage::towel_cabinet),
    indoor("under_sink_cabinet", 6, storage::under_sink_cabinet),
    indoor("towel_rack", 8, storage::towel_rack),
    indoor("heated_towel_rail", 5, storage::heated_towel_rail),
    indoor("shower_caddy", 6, storage::shower_caddy),
    indoor("bathroom_mirror", 9, storage::bathroom_mirror),
    indoor("toilet_roll_holder", 4, hung::toilet_roll_holder),
    indoor("shower_curtain", 4, hung::shower_curtain),
    indoor("toilet", 9, fixture::toilet),
    indoor("bidet", 4, fixture::bidet),
    indoor("washbasin", 9, fixture::washbasin),
    indoor("bathtub", 8, fixture::bathtub),
    indoor("shower", 6, fixture::shower),
    indoor("shower_stall", 6, fixture::shower_stall),
    indoor("faucet", 10, tap::faucet),
    indoor("shower_head", 6, tap::shower_head),
];
