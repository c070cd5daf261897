// Straight line by minimum deviation: one step a clock, an adder an axis, one counter for all.
//
// The longest axis is fed on every step, another one when it would be more than half a pulse behind.
// D = 2(k|end| - longest p) + 2|end| - longest - 1 after k steps and p pulses: not negative, a pulse
// is due. Without one it grows by 2|end|, with one it loses 2(longest - |end|), which is REST.
module minimum_deviation_line #(
    parameter N    = 24,
    parameter AXES = 2
) (
    input  wire                  i_clk,
    input  wire                  i_rst,
    // pulse source
    input  wire                  i_en,
    // command: the registers' first contents; D begins with |end| - REST - 1
    input  wire                  i_load,
    input  wire [AXES*N-1:0]     i_end,
    input  wire [AXES*N-1:0]     i_rest,
    input  wire [AXES*(N+2)-1:0] i_d,
    input  wire [N-1:0]          i_steps,
    input  wire [AXES-1:0]       i_negative,
    // pulses of this clock, and their directions
    output wire [AXES-1:0]       o_pulse,
    output reg  [AXES-1:0]       o_negative,
    output wire                  o_done,
    // registers
    output reg  [AXES*(N+2)-1:0] o_d,
    output reg  [AXES*N-1:0]     o_end,
    output reg  [AXES*N-1:0]     o_rest,
    output reg  [N-1:0]          o_steps
);
    wire [AXES-1:0]       feeds;
    wire [AXES*(N+2)-1:0] d_next;
    wire                  run = i_en & ~o_done;

    assign o_done  = o_steps == 0;
    assign o_pulse = feeds & {AXES{run}};

    genvar axis;
    generate
        for (axis = 0; axis < AXES; axis = axis + 1) begin : axes
            wire [N+1:0] d      = o_d[axis*(N+2) +: N+2];
            wire         is_due = ~d[N+1];
            wire [N-1:0] way    = is_due ? ~o_rest[axis*N +: N] : o_end[axis*N +: N];
            // -2r is 2(~r + 1), so the adder's carry in comes in at the second place
            wire [N:0]   half   = d[N+1:1] + {is_due, way} + {{N{1'b0}}, is_due};
            assign feeds[axis]  = is_due;
            assign d_next[axis*(N+2) +: N+2] = {half, d[0]};
        end
    endgenerate

    always @(posedge i_clk)
        if (i_rst) begin
            o_d        <= {AXES*(N+2){1'b0}};
            o_end      <= {AXES*N{1'b0}};
            o_rest     <= {AXES*N{1'b0}};
            o_steps    <= {N{1'b0}};
            o_negative <= {AXES{1'b0}};
        end else if (i_load) begin
            o_d        <= i_d;
            o_end      <= i_end;
            o_rest     <= i_rest;
            o_steps    <= i_steps;
            o_negative <= i_negative;
        end else if (run) begin
            o_d     <= d_next;
            o_steps <= o_steps - 1'b1;
        end
endmodule
