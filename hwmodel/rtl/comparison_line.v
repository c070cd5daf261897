// Straight line by comparison integration: one step a clock.
//
// A pulse of x takes an interval |ye|, a pulse of y an interval |xe|. D is twice the difference between
// the times at which the next ones are due: not above 0 it feeds x and adds 2|ye|, not below 0 it feeds y and
// takes 2|xe|. The adders' carries run together, one place apart.
module comparison_line #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source
    input  wire         i_en,
    // command: end point, and the first D, |ye| - |xe|
    input  wire         i_load,
    input  wire [N-1:0] i_end_x,
    input  wire [N-1:0] i_end_y,
    input  wire [N+1:0] i_d,
    input  wire [1:0]   i_negative,
    // pulses of this clock, and their directions
    output wire [1:0]   o_pulse,
    output reg  [1:0]   o_negative,
    output wire         o_done,
    // registers
    output reg  [N+1:0] o_d,
    output reg  [N-1:0] o_end_x,
    output reg  [N-1:0] o_end_y,
    output reg  [N-1:0] o_jex,
    output reg  [N-1:0] o_jey
);
    wire         feeds_y = ~o_d[N+1];
    wire         feeds_x = o_d[N+1] | o_d == 0;
    wire         run     = i_en & ~o_done;
    wire [N+1:0] later_x = {1'b0, o_end_y & {N{feeds_x}}, 1'b0};
    wire [N+1:0] later_y = {1'b0, o_end_x & {N{feeds_y}}, 1'b0};

    assign o_done  = o_jex == 0 & o_jey == 0;
    assign o_pulse = {feeds_y, feeds_x} & {2{run}};

    always @(posedge i_clk)
        if (i_rst) begin
            o_d        <= {(N+2){1'b0}};
            o_end_x    <= {N{1'b0}};
            o_end_y    <= {N{1'b0}};
            o_jex      <= {N{1'b0}};
            o_jey      <= {N{1'b0}};
            o_negative <= 2'b00;
        end else if (i_load) begin
            o_d        <= i_d;
            o_end_x    <= i_end_x;
            o_end_y    <= i_end_y;
            o_jex      <= i_end_x;
            o_jey      <= i_end_y;
            o_negative <= i_negative;
        end else if (run) begin
            o_d   <= o_d + later_x - later_y;
            o_jex <= o_jex - {{(N-1){1'b0}}, feeds_x};
            o_jey <= o_jey - {{(N-1){1'b0}}, feeds_y};
        end
endmodule
