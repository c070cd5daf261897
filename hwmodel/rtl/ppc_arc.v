// Circular arc by point-by-point comparison: four beats, four clocks a step.
//
//   0 judge    what is due: towards zero if F >= 0, else away from it; a standing axis never is
//   1 feed     the pulse; a coordinate that goes towards zero takes it
//   2 update   F <- F - 2c - 1 (towards zero)  or  F + 2c + 1, c <- c + 1 (away); the counters
//              take the pulse
//   3 compare  which counters have come to their end; the quadrant is left when c has become 0
//
// CX and CY are the magnitudes of the moving point; a pulse changes F by twice the smaller of the
// two that it lies between, and 1, so one adder without a carry in does. F may wrap once it decides nothing any more:
// when an end point off the circle is stepped out to.
module ppc_arc #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source: begins a step, when none is under way
    input  wire         i_en,
    // command: the registers' first contents, end rule (0 total, 1 per axis, 2 larger)
    input  wire         i_load,
    input  wire [N-1:0] i_cx,
    input  wire [N-1:0] i_cy,
    input  wire [1:0]   i_quadrant,
    input  wire [2:0]   i_crossings,
    input  wire         i_cw,
    input  wire [N+1:0] i_jex,
    input  wire [N+1:0] i_jey,
    input  wire [1:0]   i_rule,
    input  wire         i_larger_is_y,
    input  wire [N+3:0] i_e,
    // pulses of this clock, and their directions
    output wire [1:0]   o_pulse,
    output wire [1:0]   o_negative,
    output wire         o_done,
    // registers
    output reg  [1:0]   o_rule,
    output reg          o_larger_is_y,
    output reg  [1:0]   o_beat,
    output reg          o_fx,
    output reg  [N+1:0] o_f,
    output reg  [N-1:0] o_cx,
    output reg  [N-1:0] o_cy,
    output reg  [N+3:0] o_e,
    // registers of the sweep
    output wire [1:0]   o_quadrant,
    output wire [2:0]   o_crossings,
    output wire         o_cw,
    output wire [N+1:0] o_jex,
    output wire [N+1:0] o_jey,
    output wire         o_last,
    output wire         o_towards_is_y,
    output wire         o_feeds_nx,
    output wire         o_feeds_ny,
    output wire         o_at_end_x,
    output wire         o_at_end_y,
    output wire         o_stands_x,
    output wire         o_stands_y,
    output wire         o_stepping_out,
    output wire         o_nx,
    output wire         o_ny,
    output wire         o_shrinks_x,
    output wire         o_shrinks_y
);
    localparam JUDGE = 2'd0, FEED = 2'd1, UPDATE = 2'd2, COMPARE = 2'd3;
    localparam TOTAL = 2'd0, PER_AXIS = 2'd1;

    wire is_last;
    wire counted_out = o_rule == PER_AXIS ? is_last : o_e == 0;
    wire counts      = o_rule == TOTAL | (o_rule != PER_AXIS & (o_larger_is_y ^ o_fx));
    wire run         = o_beat != JUDGE | (i_en & ~counted_out);

    assign o_negative = {o_ny, o_nx};
    assign o_done     = o_beat == JUDGE & counted_out;
    assign o_pulse    = {~o_fx, o_fx} & {2{o_beat == FEED}};

    // Judge.
    wire towards_stands = o_towards_is_y ? o_stands_y : o_stands_x;
    wire away_stands    = o_towards_is_y ? o_stands_x : o_stands_y;
    wire feeds_towards  = (~o_f[N+1] & ~towards_stands) | away_stands;
    wire due_x          = o_stands_x & o_stands_y ? ~o_at_end_x : feeds_towards ^ o_towards_is_y;

    // Feed and update.
    wire         shrinks = o_fx ? o_shrinks_x : o_shrinks_y;
    wire         moves   = o_beat == (shrinks ? FEED : UPDATE);
    wire [N-1:0] c       = o_fx ? o_cx : o_cy;
    wire [N-1:0] c_next  = c + {{(N-1){shrinks}}, 1'b1};
    // -2c - 1 is ~2c
    wire [N+1:0] change  = {1'b0, c, 1'b1} ^ {{(N+1){shrinks}}, 1'b0};

    wire update = o_beat == UPDATE;

    sweep #(.N(N)) sweep (
        .i_clk         (i_clk),
        .i_rst         (i_rst),
        .i_load        (i_load),
        .i_quadrant    (i_quadrant),
        .i_crossings   (i_crossings),
        .i_cw          (i_cw),
        .i_jex         (i_jex),
        .i_jey         (i_jey),
        .i_look        (o_beat == COMPARE),
        .i_x_is_zero   (o_cx == 0),
        .i_y_is_zero   (o_cy == 0),
        .i_px          (update & o_fx),
        .i_nx          (o_nx),
        .i_py          (update & ~o_fx),
        .i_ny          (o_ny),
        .o_done        (is_last),
        .o_quadrant    (o_quadrant),
        .o_crossings   (o_crossings),
        .o_cw          (o_cw),
        .o_jex         (o_jex),
        .o_jey         (o_jey),
        .o_last        (o_last),
        .o_towards_is_y(o_towards_is_y),
        .o_feeds_nx    (o_feeds_nx),
        .o_feeds_ny    (o_feeds_ny),
        .o_at_end_x    (o_at_end_x),
        .o_at_end_y    (o_at_end_y),
        .o_stands_x    (o_stands_x),
        .o_stands_y    (o_stands_y),
        .o_stepping_out(o_stepping_out),
        .o_nx          (o_nx),
        .o_ny          (o_ny),
        .o_shrinks_x   (o_shrinks_x),
        .o_shrinks_y   (o_shrinks_y)
    );

    always @(posedge i_clk)
        if (i_rst) begin
            o_beat        <= JUDGE;
            o_fx          <= 1'b1;
            o_f           <= {(N+2){1'b0}};
            o_cx          <= {N{1'b0}};
            o_cy          <= {N{1'b0}};
            o_e           <= {(N+4){1'b0}};
            o_rule        <= TOTAL;
            o_larger_is_y <= 1'b0;
        end else if (i_load) begin
            o_beat        <= JUDGE;
            o_fx          <= ~(i_quadrant[0] ^ i_cw);
            o_f           <= {(N+2){1'b0}};
            o_cx          <= i_cx;
            o_cy          <= i_cy;
            o_e           <= i_e;
            o_rule        <= i_rule;
            o_larger_is_y <= i_larger_is_y;
        end else if (run) begin
            o_beat <= o_beat + 2'd1;
            if (o_beat == JUDGE) o_fx <= due_x;
            if (moves & o_fx) o_cx <= c_next;
            if (moves & ~o_fx) o_cy <= c_next;
            if (update) begin
                o_f <= o_f + change;
                if (counts) o_e <= o_e - 1'b1;
            end
        end
endmodule
