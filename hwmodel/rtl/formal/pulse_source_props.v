// What the pulse source always does: whatever the period, whoever makes it wait.
module pulse_source_props #(
    // bits of a period
    parameter N = 24
) (
    input wire         clk,
    input wire         rst,
    input wire [N-1:0] period,
    input wire         ready
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire         tick, due;
    wire [N-1:0] count;
    pulse_source #(.P(N)) source (
        .i_clk(clk), .i_rst(first | rst), .i_period(period), .i_ready(ready), .o_tick(tick),
        .o_due(due), .o_count(count)
    );

    // The period of the last tick, and the clocks since, which stand when it is over.
    reg  [N-1:0] asked = 0, since = 0;
    reg          ran   = 1'b0;
    wire         over  = since == asked;
    always @(posedge clk)
        if (first | rst) begin
            ran <= 1'b0;
        end else if (tick) begin
            ran   <= 1'b1;
            asked <= period;
            since <= 1;
        end else if (ran & ~over)
            since <= since + 1'b1;

    always @* assume (period >= 2);

    always @* if (!first & ~rst) begin
        // Not without leave, not before the period is over, and then at once.
        if (tick) assert (ready);
        if (ran & ~over) assert (~tick);
        if (ready & (~ran | over)) assert (tick);
    end

    // What makes that an induction.
    always @* if (!first) begin
        if (~ran) assert (due);
        if (ran) begin
            assert (asked >= 2 && since >= 1 && since <= asked);
            assert (due == over);
            if (~over) assert (count == asked - since - 1'b1);
            else assert (count == 0);
        end
    end
endmodule
