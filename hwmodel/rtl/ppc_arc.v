// Circular arc by point-by-point comparison: four beats, four clocks a step.
//
//   0 judge    what is due: towards zero if F >= 0, else away from it; a standing axis never is
//   1 feed     the pulse
//   2 update   F <- F - 2c + 1, c <- c - 1 (towards zero)  or  F + 2c + 1, c + 1 (away)
//   3 compare  the counters take the pulse; the quadrant is left when c has become 0
//
// CX and CY are the magnitudes of the moving point. F may wrap once it decides nothing any more:
// when an end point off the circle is stepped out to.
module ppc_arc #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source
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
    output wire [1:0]   o_quadrant,
    output wire [2:0]   o_crossings,
    output wire [N+1:0] o_jex,
    output wire [N+1:0] o_jey,
    output reg  [N+3:0] o_e
);
    localparam JUDGE = 2'd0, FEED = 2'd1, UPDATE = 2'd2, COMPARE = 2'd3;
    localparam TOTAL = 2'd0, PER_AXIS = 2'd1;

    // The direction of the due pulse.
    reg        negative;

    wire towards_is_y, nx, ny, x_stands, y_stands, sweep_done;
    wire counted_out = o_rule == PER_AXIS ? sweep_done : o_e == 0;
    wire counts      = o_rule == TOTAL | (o_rule != PER_AXIS & (o_larger_is_y ^ o_fx));
    wire run         = i_en & ~o_done;

    assign o_done     = o_beat == JUDGE & counted_out;
    assign o_pulse    = {~o_fx, o_fx} & {2{i_en & o_beat == FEED}};
    assign o_negative = {2{negative}};

    // Judge.
    wire towards_stands = towards_is_y ? y_stands : x_stands;
    wire away_stands    = towards_is_y ? x_stands : y_stands;
    wire both_stand     = x_stands & y_stands;
    wire feeds_towards  = (~o_f[N+1] & ~towards_stands) | away_stands;
    wire due_x          = both_stand ? o_jex != 0 : feeds_towards ^ towards_is_y;
    wire due_negative   = both_stand ? (due_x ? o_jex[N+1] : o_jey[N+1]) : (due_x ? nx : ny);

    // Update: the due coordinate shrinks if its axis is the one fed towards zero, unless the pulse
    // goes against the quadrant's direction.
    wire [N-1:0] c       = o_fx ? o_cx : o_cy;
    wire         shrinks = (towards_is_y ^ o_fx) ^ (negative ^ (o_fx ? nx : ny));
    wire [N-1:0] c_next  = shrinks ? c - 1'b1 : c + 1'b1;
    wire [N+1:0] twice   = {1'b0, c, 1'b0};
    wire [N+1:0] f_next  = (shrinks ? o_f - twice : o_f + twice) + 1'b1;

    wire takes_pulse = run & o_beat == COMPARE;

    /* verilator lint_off PINCONNECTEMPTY */ // judging steps out by itself
    sweep #(.N(N)) sweep (
        .i_clk         (i_clk),
        .i_rst         (i_rst),
        .i_load        (i_load),
        .i_quadrant    (i_quadrant),
        .i_crossings   (i_crossings),
        .i_cw          (i_cw),
        .i_jex         (i_jex),
        .i_jey         (i_jey),
        .i_en          (takes_pulse),
        .i_px          (o_fx),
        .i_nx          (negative),
        .i_py          (~o_fx),
        .i_ny          (negative),
        .i_x_is_zero   (1'b0),
        .i_y_is_zero   (1'b0),
        .i_x_gets_zero (o_cx == 0),
        .i_y_gets_zero (o_cy == 0),
        .o_towards_is_y(towards_is_y),
        .o_nx          (nx),
        .o_ny          (ny),
        .o_x_stands    (x_stands),
        .o_y_stands    (y_stands),
        .o_stepping_out(),
        .o_done        (sweep_done),
        .o_quadrant    (o_quadrant),
        .o_crossings   (o_crossings),
        .o_cw          (),
        .o_jex         (o_jex),
        .o_jey         (o_jey)
    );
    /* verilator lint_on PINCONNECTEMPTY */

    always @(posedge i_clk)
        if (i_rst) begin
            o_beat      <= JUDGE;
            o_fx        <= 1'b1;
            o_f         <= {(N+2){1'b0}};
            o_cx        <= {N{1'b0}};
            o_cy        <= {N{1'b0}};
            o_e         <= {(N+4){1'b0}};
            o_rule        <= TOTAL;
            o_larger_is_y <= 1'b0;
            negative    <= 1'b0;
        end else if (i_load) begin
            o_beat      <= JUDGE;
            o_fx        <= ~(i_quadrant[0] ^ i_cw);
            o_f         <= {(N+2){1'b0}};
            o_cx        <= i_cx;
            o_cy        <= i_cy;
            o_e         <= i_e;
            o_rule        <= i_rule;
            o_larger_is_y <= i_larger_is_y;
            negative    <= 1'b0;
        end else if (run) begin
            o_beat <= o_beat + 2'd1;
            case (o_beat)
                JUDGE: begin
                    o_fx     <= due_x;
                    negative <= due_negative;
                end
                UPDATE: begin
                    o_f <= f_next;
                    if (o_fx) o_cx <= c_next;
                    else o_cy <= c_next;
                end
                COMPARE: if (counts) o_e <= o_e - 1'b1;
                default: ;
            endcase
        end
endmodule
