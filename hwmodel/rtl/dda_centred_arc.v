// Circular arc by digital integration, staggered and centred: the circuit that keeps one pulse.
//
// Counter-clockwise, in one clock: JRx <- JRx - y, a carry is a +x pulse and a borrow a -x pulse;
// then JRy <- JRy + x with the x that already has that pulse. Clockwise: both signs turned. The
// coordinates are signed and carry the factor i_unit = 2^Q.
//
// The two additions of a clock stand in a row; that is the price of staggering without a second
// clock.
module dda_centred_arc #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source
    input  wire         i_en,
    // command: the registers' first contents
    input  wire         i_load,
    input  wire [N-1:0] i_x,
    input  wire [N-1:0] i_y,
    input  wire [N-1:0] i_jrx,
    input  wire [N-1:0] i_jry,
    input  wire [N-1:0] i_unit,
    input  wire [1:0]   i_quadrant,
    input  wire [2:0]   i_crossings,
    input  wire         i_cw,
    input  wire [N+1:0] i_jex,
    input  wire [N+1:0] i_jey,
    // pulses of this clock, and their directions
    output wire [1:0]   o_pulse,
    output wire [1:0]   o_negative,
    output wire         o_done,
    // registers
    output reg  [N-1:0] o_unit,
    output wire         o_cw,
    output reg  [N-1:0] o_x,
    output reg  [N-1:0] o_y,
    output reg  [N-1:0] o_jrx,
    output reg  [N-1:0] o_jry,
    output wire [1:0]   o_quadrant,
    output wire [2:0]   o_crossings,
    output wire [N+1:0] o_jex,
    output wire [N+1:0] o_jey
);
    wire         x_stands, y_stands, stepping_out;
    wire         run = i_en & ~o_done;

    // A remainder is unsigned, a coordinate signed: in N + 2 bits the sum's two top bits are 00
    // (no pulse), 01 (carry) or 11 (borrow).
    wire [N+1:0] x_wide  = {{2{o_x[N-1]}}, o_x};
    wire [N+1:0] y_wide  = {{2{o_y[N-1]}}, o_y};
    wire [N+1:0] sum_x   = {2'b00, o_jrx} + (o_cw ? y_wide : ~y_wide + 1'b1);
    wire         carry_x = sum_x[N];
    wire         px      = run & (stepping_out ? o_jex != 0 : carry_x & ~x_stands);
    wire         sx      = stepping_out ? o_jex[N+1] : sum_x[N+1];
    wire [N-1:0] x_next  = px ? (sx ? o_x - o_unit : o_x + o_unit) : o_x;

    // Staggered: what y adds has x's pulse of this clock.
    wire [N+1:0] x_fresh = px ? (sx ? x_wide - {2'b00, o_unit} : x_wide + {2'b00, o_unit}) : x_wide;
    wire [N+1:0] sum_y   = {2'b00, o_jry} + (o_cw ? ~x_fresh + 1'b1 : x_fresh);
    wire         carry_y = sum_y[N];
    wire         py      = run & (stepping_out ? o_jey != 0 : carry_y & ~y_stands);
    wire         sy      = stepping_out ? o_jey[N+1] : sum_y[N+1];
    wire [N-1:0] y_next  = py ? (sy ? o_y - o_unit : o_y + o_unit) : o_y;

    assign o_pulse    = {py, px};
    assign o_negative = {sy, sx};

    /* verilator lint_off PINCONNECTEMPTY */ // signed coordinates need no decoded directions
    sweep #(.N(N)) sweep (
        .i_clk         (i_clk),
        .i_rst         (i_rst),
        .i_load        (i_load),
        .i_quadrant    (i_quadrant),
        .i_crossings   (i_crossings),
        .i_cw          (i_cw),
        .i_jex         (i_jex),
        .i_jey         (i_jey),
        .i_en          (run),
        .i_px          (px),
        .i_nx          (sx),
        .i_py          (py),
        .i_ny          (sy),
        .i_x_is_zero   (o_x == 0),
        .i_y_is_zero   (o_y == 0),
        .i_x_gets_zero (x_next == 0),
        .i_y_gets_zero (y_next == 0),
        .o_towards_is_y(),
        .o_nx          (),
        .o_ny          (),
        .o_x_stands    (x_stands),
        .o_y_stands    (y_stands),
        .o_stepping_out(stepping_out),
        .o_done        (o_done),
        .o_quadrant    (o_quadrant),
        .o_crossings   (o_crossings),
        .o_cw          (o_cw),
        .o_jex         (o_jex),
        .o_jey         (o_jey)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    always @(posedge i_clk)
        if (i_rst) begin
            o_unit <= {N{1'b0}};
            o_x   <= {N{1'b0}};
            o_y   <= {N{1'b0}};
            o_jrx <= {N{1'b0}};
            o_jry <= {N{1'b0}};
        end else if (i_load) begin
            o_unit <= i_unit;
            o_x   <= i_x;
            o_y   <= i_y;
            o_jrx <= i_jrx;
            o_jry <= i_jry;
        end else if (run) begin
            o_x <= x_next;
            o_y <= y_next;
            if (~stepping_out & ~x_stands) o_jrx <= sum_x[N-1:0];
            if (~stepping_out & ~y_stands) o_jry <= sum_y[N-1:0];
        end
endmodule
