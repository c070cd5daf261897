// Straight line by point-by-point comparison: four beats, four clocks a step.
//
//   0 judge    which axis is due: x if F >= 0 and x is not done, or y is done
//   1 feed     the pulse
//   2 update   F <- F - |ye| after an x pulse, F + |xe| after a y pulse
//   3 compare  the counters take the pulse
//
// One adder does; the beats share it.
module ppc_line #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source: begins a step, when none is under way
    input  wire         i_en,
    // command: end point, end rule (0 total, 1 per axis, 2 larger), and what E counts
    input  wire         i_load,
    input  wire [N-1:0] i_end_x,
    input  wire [N-1:0] i_end_y,
    input  wire [1:0]   i_negative,
    input  wire [1:0]   i_rule,
    input  wire         i_larger_is_y,
    input  wire [N:0]   i_e,
    // pulses of this clock, and their directions
    output wire [1:0]   o_pulse,
    output reg  [1:0]   o_negative,
    output wire         o_done,
    // registers
    output reg  [1:0]   o_rule,
    output reg          o_larger_is_y,
    output reg  [1:0]   o_beat,
    output reg          o_fx,
    output reg  [N:0]   o_f,
    output reg  [N-1:0] o_end_x,
    output reg  [N-1:0] o_end_y,
    output reg  [N-1:0] o_jex,
    output reg  [N-1:0] o_jey,
    output reg  [N:0]   o_e
);
    localparam JUDGE = 2'd0, FEED = 2'd1, UPDATE = 2'd2, COMPARE = 2'd3;
    localparam TOTAL = 2'd0, PER_AXIS = 2'd1;

    wire       x_done = o_jex == 0;
    wire       y_done = o_jey == 0;
    wire       counted_out = o_rule == PER_AXIS ? x_done & y_done : o_e == 0;
    wire       counts = o_rule == TOTAL | (o_rule != PER_AXIS & (o_larger_is_y ^ o_fx));
    wire       run = o_beat != JUDGE | (i_en & ~counted_out);
    wire [N:0] change = o_fx ? ~{1'b0, o_end_y} + 1'b1 : {1'b0, o_end_x};

    assign o_done  = o_beat == JUDGE & counted_out;
    assign o_pulse = {~o_fx, o_fx} & {2{o_beat == FEED}};

    always @(posedge i_clk)
        if (i_rst) begin
            o_beat        <= JUDGE;
            o_fx          <= 1'b1;
            o_f           <= {(N+1){1'b0}};
            o_end_x       <= {N{1'b0}};
            o_end_y       <= {N{1'b0}};
            o_jex         <= {N{1'b0}};
            o_jey         <= {N{1'b0}};
            o_e           <= {(N+1){1'b0}};
            o_negative    <= 2'b00;
            o_rule        <= TOTAL;
            o_larger_is_y <= 1'b0;
        end else if (i_load) begin
            o_beat        <= JUDGE;
            o_fx          <= 1'b1;
            o_f           <= {(N+1){1'b0}};
            o_end_x       <= i_end_x;
            o_end_y       <= i_end_y;
            o_jex         <= i_end_x;
            o_jey         <= i_end_y;
            o_e           <= i_e;
            o_negative    <= i_negative;
            o_rule        <= i_rule;
            o_larger_is_y <= i_larger_is_y;
        end else if (run) begin
            o_beat <= o_beat + 2'd1;
            case (o_beat)
                JUDGE:   o_fx <= (~o_f[N] & ~x_done) | y_done;
                UPDATE:  o_f <= o_f + change;
                COMPARE: begin
                    if (o_fx) o_jex <= o_jex - 1'b1;
                    else o_jey <= o_jey - 1'b1;
                    if (counts) o_e <= o_e - 1'b1;
                end
                default: ;
            endcase
        end
endmodule
