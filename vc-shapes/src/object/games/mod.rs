//! Games: tables and machines of a game room, boards, boxes and small pieces.

mod bar;
mod board;
mod machine;
mod pieces;
mod table;

use super::rest::settled;
use super::{Generator, indoor};

pub(super) const GENERATORS: &[Generator] = &[
    indoor("air_hockey_table", 3, table::air_hockey),
    indoor("foosball_table", 3, table::foosball),
    indoor("pool_table", 4, table::pool),
    indoor("ping_pong_table", 3, table::ping_pong),
    indoor("poker_table", 2, table::poker),
    indoor("arcade_machine", 4, machine::arcade),
    indoor("pinball_machine", 2, machine::pinball),
    indoor("claw_machine", 2, machine::claw),
    indoor("jukebox", 2, machine::jukebox),
    indoor("dartboard", 3, bar::dartboard),
    indoor("darts", 2, |b| settled(b, bar::darts)),
    indoor("cue_rack", 2, bar::cue_rack),
    indoor("billiard_cue", 3, bar::cue),
    indoor("billiard_balls", 2, bar::balls),
    indoor("air_hockey_mallet", 2, bar::mallet),
    indoor("board_game", 4, board::boxed),
    indoor("monopoly", 2, board::boxed),
    indoor("ludo", 2, board::boxed),
    indoor("scrabble", 2, board::boxed),
    indoor("memory_game", 2, board::boxed),
    indoor("jigsaw_puzzle", 3, board::boxed),
    indoor("chessboard", 3, board::chequered),
    indoor("checkers", 2, board::chequered),
    indoor("go_board", 2, board::go),
    indoor("backgammon", 2, board::backgammon),
    indoor("dominoes", 2, pieces::tiles),
    indoor("mahjong", 2, pieces::tiles),
    indoor("tumbling_tower", 2, pieces::tower),
    indoor("puzzle_cube", 2, pieces::cube),
    indoor("deck_of_cards", 2, pieces::deck),
    indoor("cards", 2, pieces::cards),
    indoor("dice", 2, pieces::dice),
    indoor("poker_chips", 2, pieces::chips),
];
