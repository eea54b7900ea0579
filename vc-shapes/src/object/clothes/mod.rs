//! Clothes that hang or lie folded, shoes, bags and accessories.

mod accessory;
mod bag;
mod garment;
mod headwear;
mod legwear;
mod luggage;
mod shoe;
mod small;

use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("t_shirt", 8, garment::top),
    indoor("shirt", 6, garment::top),
    indoor("sweater", 6, garment::top),
    indoor("hoodie", 4, garment::top),
    indoor("jacket", 6, garment::top),
    indoor("coat", 6, garment::top),
    indoor("raincoat", 3, garment::top),
    indoor("suit", 3, garment::top),
    indoor("dress", 6, garment::top),
    indoor("bathrobe", 3, garment::top),
    indoor("pants", 5, legwear::trousers),
    indoor("jeans", 4, legwear::trousers),
    indoor("shorts", 3, legwear::trousers),
    indoor("skirt", 4, legwear::skirt),
    indoor("pajamas", 3, garment::top),
    indoor("scarf", 3, small::scarf),
    indoor("socks", 3, small::socks),
    indoor("underwear", 2, small::briefs),
    indoor("swimsuit", 3, small::briefs),
    indoor("bra", 1, small::bra),
    indoor("tie", 2, small::tie),
    indoor("belt", 2, small::belt),
    indoor("gloves", 2, small::gloves),
    indoor("clothes_pile", 4, small::pile),
    indoor("hat", 6, headwear::hat),
    indoor("cap", 4, headwear::cap),
    indoor("shoes", 8, shoe::pair),
    indoor("sneakers", 6, shoe::pair),
    indoor("boots", 5, shoe::pair),
    indoor("sandals", 3, shoe::pair),
    indoor("high_heels", 3, shoe::pair),
    indoor("slippers", 4, shoe::pair),
    indoor("shoe_shine_kit", 1, accessory::shoe_shine_kit),
    indoor("shoe_horn", 1, accessory::shoe_horn),
    indoor("spectacles", 2, accessory::spectacles),
    indoor("sunglasses", 2, accessory::spectacles),
    indoor("umbrella", 5, accessory::umbrella),
    indoor("wallet", 2, accessory::wallet),
    indoor("keys", 3, accessory::keys),
    indoor("hanger", 3, accessory::hanger),
    indoor("bag", 4, bag::handbag),
    indoor("purse", 4, bag::handbag),
    indoor("shopping_bag", 3, bag::tote),
    indoor("laundry_bag", 2, bag::tote),
    indoor("backpack", 6, luggage::backpack),
    indoor("suitcase", 4, luggage::suitcase),
    indoor("briefcase", 2, luggage::briefcase),
];
