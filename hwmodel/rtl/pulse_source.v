// The pulse source: divides the system clock to the rate of cycles, which is the feed.
//
// o_tick starts a cycle; the next comes i_period clocks later, or as soon after that as somebody
// can take it. The period is that of the clock of the tick, at least 2.
module pulse_source #(
    parameter P = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    input  wire [P-1:0] i_period,
    // a cycle can be taken
    input  wire         i_ready,
    output wire         o_tick,
    // registers
    output reg          o_due,
    output reg  [P-1:0] o_count
);
    assign o_tick = o_due & i_ready;

    localparam [P-1:0] TWO = 2;

    always @(posedge i_clk)
        if (i_rst) begin
            o_due   <= 1'b1;
            o_count <= {P{1'b0}};
        end else if (o_tick) begin
            o_due   <= 1'b0;
            o_count <= i_period - TWO;
        end else if (o_count == 0)
            o_due   <= 1'b1;
        else
            o_count <= o_count - 1'b1;
endmodule
